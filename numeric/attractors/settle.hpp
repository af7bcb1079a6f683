// What a simulated motion of the paper's oscillator settles on: follower.hpp, and what is known of it in
// closed form. A motion has settled, too, when
//   it slips, and the three harmonics of its speed can never again add up to the belt's,
//   it sticks to a belt that stands still, and its friction at rest can never again reach ur.
#pragma once

#include "numeric/attractors/follower.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::attractors {

// The events as a guess of an orbit of a word.
[[nodiscard]] words::Guess word_guess(const Return& seen);

// The state of the motion when the load's phase is next a multiple of 2 pi.
[[nodiscard]] model::Vector4<double> at_phase_0(const simulation::Start& start);

class Follower : public FollowerOf<2, 1> {
 public:
  // From X at t = 0, the load being cos omega t. Throws as Simulation does.
  Follower(const model::Parameters<double>& a, double ur, const model::Vector4<double>& X);
};

}  // namespace stickslip::numeric::attractors
