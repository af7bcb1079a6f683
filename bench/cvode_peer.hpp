// The same law by SUNDIALS CVODE, Adams with its own root finding. A peer for speed; two zeros of an event
// function in one step are missed.
#pragma once

#include <span>

#include "bench/raw_law.hpp"

namespace stickslip::bench {

// Follows the motion from x to where it is after the duration; returns the number of events. `tolerance`
// bounds the error of each step, relative and absolute. Throws InternalError when CVODE gives up.
int follow_by_cvode(RawLaw& law, std::span<double> x, double duration, double tolerance);

}  // namespace stickslip::bench
