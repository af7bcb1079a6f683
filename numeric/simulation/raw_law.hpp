// The equations of motion (2) with the friction law (4), integrated by SUNDIALS CVODE with its root finding:
// no H, Gamma, Q or any other closed form. The independent witness of everything that rests on those.
#pragma once

#include "numeric/simulation/run.hpp"

namespace stickslip::numeric::simulation {

struct RawAccuracy {
  double tolerance = 1e-12;  // relative and absolute, of each step
  double longest_step = 0;   // 0: CVODE decides. Two zeros of an event function in one step are missed
};

// Follows the motion for the duration. Events by (4): x2' = V reached on a slip, where the mass sticks if |r|
// < ur and slips to the side of r otherwise; |r| = ur reached on a stick. Throws DomainError for a duration
// that is not finite and positive, InternalError when CVODE gives up.
[[nodiscard]] Run follow_raw_law(const Start& start, double duration, const RawAccuracy& accuracy = {});

}  // namespace stickslip::numeric::simulation
