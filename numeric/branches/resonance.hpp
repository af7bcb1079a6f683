// The friction law along symmetric orbits next to a natural frequency. There the response (7) to the load is
// unbounded, and what is made of it tells nothing; the orbits are not, nor what they have to obey in the
// functions that their symmetry leaves (atlas/symmetric_orbit.hpp).
#pragma once

#include <vector>

#include "numeric/motion/conditions.hpp"
#include "numeric/zeros/parametric.hpp"

namespace stickslip::numeric::branches {

// Whether omega is within a hundredth of a natural frequency.
[[nodiscard]] bool is_near_resonance(const motion::Motion& motion);

// Decides what is open of these conditions on all motions of a proof (zeros/parametric.hpp) if that decides
// whether they are admissible; else leaves them as they are. The motions by their jets by one parameter, and
// the one at the middle: symmetric, whose conditions are the requirements in their order.
void decide_without_response(const zeros::ParametricProof& proof,
                             const motion::MotionOf<zeros::ParameterJet>& jets, const motion::Motion& middle,
                             const motion::Requirements& requirements,
                             std::vector<motion::Condition>& conditions);

}  // namespace stickslip::numeric::branches
