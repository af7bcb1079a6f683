// The equations of motion (2) with the friction law (4), integrated by Boost.Odeint: no H, Gamma, Q or any
// other closed form. The independent witness of everything that rests on those.
//
// No event inside a step is missed, and no touch of zero: a stretch of a step is passed only when the value
// of the event function in its middle, its rate and a bound of its second derivative, all read off (2), keep
// it from zero there; else the stretch is halved. This holds for the integrated motion, up to rounding.
#pragma once

#include "numeric/simulation/record.hpp"

namespace stickslip::numeric::simulation {

// Follows the motion for the duration, with an error of each step, relative and absolute, below 1e-12.
// Events by (4): x2' = V reached on a slip, where the mass sticks if |r| < ur and slips to the side of r
// otherwise; |r| = ur reached on a stick. With us = ur = |r| it slips only if |r| goes on to grow. Throws
// DomainError for a duration that is not finite and positive, InternalError when the steps become too small,
// the motion is not finite, or (4) leaves open what follows.
[[nodiscard]] Run follow_raw_law(const Start& start, double duration);

}  // namespace stickslip::numeric::simulation
