// The same law by SUNDIALS CVODE, Adams with its own root finding. A peer for speed; two zeros of an event
// function in one step are missed.
#pragma once

#include "numeric/simulation/run.hpp"

namespace stickslip::bench {

// `tolerance` bounds the error of each step, relative and absolute. Throws InternalError when CVODE gives up.
[[nodiscard]] numeric::simulation::Run follow_by_cvode(const numeric::simulation::Start& start,
                                                       double duration, double tolerance);

}  // namespace stickslip::bench
