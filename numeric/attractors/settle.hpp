// What a simulated motion of the paper's oscillator settles on: follower.hpp, and what is known of it in
// closed form. A motion has settled, too, when
//   it slips, and the three harmonics of its speed can never again add up to the belt's,
//   it sticks to a belt that stands still, and its friction at rest can never again reach ur.
#pragma once

#include "model/parameters.hpp"
#include "numeric/attractors/follower.hpp"
#include "numeric/attractors/many_starts.hpp"

namespace stickslip::numeric::attractors {

// The state of the motion when the load's phase is next a multiple of 2 pi.
[[nodiscard]] model::Vector4<double> at_phase_0(const simulation::Start& start);

class Follower : public FollowerOf<2, 1> {
 public:
  // From X at t = 0, the load being cos omega t. Throws as Simulation does.
  Follower(const model::Parameters<double>& a, double ur, const model::Vector4<double>& X);
};

// Where simulations begin: states at random, reproducibly (random_starts_in), in a box that a machine's
// motions come from.

using StartBox = StartBoxOf<model::Vector4<double>>;
// With d = us/(chi (1 - chi)), the rest position of the second mass, and s the largest of V, 3 us, 0.1 and,
// but at resonance, 1.2 |q2| omega, a speed: x1 in chi d ± 2 s, x2 in d ± 3 s, x1' in ± 1.5 s, x2' in V - s
// ± 1.5 s.
[[nodiscard]] StartBox start_box(const model::Parameters<double>& a);

}  // namespace stickslip::numeric::attractors
