// Balls for readers.
#pragma once

#include <string>

#include "core/ball.hpp"

namespace stickslip::report {

// A shorter ball that contains the given one, its midpoint to at most `digits` significant digits: "7.7492
// ± 4.0e-5". An unbounded ball reads "unbounded".
[[nodiscard]] std::string readable(const BallText& ball, int digits);

}  // namespace stickslip::report
