// Branches of symmetric orbits next to a natural frequency, and of others where a multiple of the load's is
// one.
#pragma once

#include <string>
#include <vector>

#include "numeric/branches/branches.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/zeros/parametric.hpp"

namespace stickslip::numeric::branches {

// The friction law along symmetric orbits next to a natural frequency. There the response (7) to the load is
// unbounded, and what is made of it tells nothing; the orbits are not, nor what they have to obey in the
// functions that their symmetry leaves (atlas/symmetric_orbit.hpp).

// Whether omega is within a hundredth of a natural frequency.
[[nodiscard]] bool is_near_resonance(const motion::Motion& motion);

// Decides what is open of these conditions on all motions of a proof (zeros/parametric.hpp) if that decides
// whether they are admissible; else leaves them as they are. The motions by their jets by one parameter, and
// the one at the middle: symmetric, whose conditions are the requirements in their order.
void decide_without_response(const zeros::ParametricProof& proof,
                             const motion::MotionOf<zeros::ParameterJet>& jets, const motion::Motion& middle,
                             const motion::Requirements& requirements,
                             std::vector<motion::Condition>& conditions);

// Where a multiple of the load's frequency is a natural frequency, k omega = omega_j, the closing conditions
// of orbits that never stick are singular (families/nonsticking.hpp), and beside it orbits crowd or grow
// without an end, for k = 1 with the response (7): no search comes through there, and none is made near it.
//
// So it is with overshooting orbits. There the equations of mode j vanish with the duration T of the stick
// where tau is a multiple of Theta/k; beside it their zeros run to T = 0 as the cube root of the distance,
// and a search that is to exclude all others next to them takes the longer the nearer it comes: longest with
// ur given, where the load's phase is one more unknown. Where k omega = 1 with k >= 1 the mass m1 alone, on a
// stick of the whole period, is free after it, and the equations are singular at tau + tau1 = 0.

struct Multiple {
  std::string name;  // "2 omega = omega1", "omega = 1"
  // Of the parameter: all values at which k omega is within 7.6e-6 of the frequency, relatively; of
  // overshooting orbits at a given ur, within 4.9e-4.
  Rational from, to;
  // Contains a value at which they are equal; nothing where that is not proved, as where the interval ends.
  std::optional<Ball> at;
};

// Those of the question's interval, in order and apart; none for families and words that go on there, or
// where they fill the interval or are too many.
[[nodiscard]] std::vector<Multiple> multiples_in(const BranchQuestion& question);

// What is said of it.
[[nodiscard]] UnresolvedPart left_out(const Multiple& multiple, const std::string& parameter);

}  // namespace stickslip::numeric::branches
