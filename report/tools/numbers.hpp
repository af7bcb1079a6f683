// Balls for readers.
#pragma once

#include <string>

#include "core/ball.hpp"

namespace stickslip::report::tools {

// A shorter ball that contains the given one, its midpoint to at most `digits` significant digits: "7.7492
// ± 4.0e-5". An unbounded ball reads "unbounded".
[[nodiscard]] std::string readable(const BallText& ball, int digits);

// The digits that are worth printing: at most `digits`, and not many more than the ball knows; at least 2.
[[nodiscard]] int known_digits(const Ball& ball, int digits);

// A decimal without radius: at most `digits` significant digits, each of them right to one unit of the last
// one; a ball that knows fewer than 2 digits reads "mid ± rad", an unbounded one "unbounded".
[[nodiscard]] std::string rounded(const Ball& ball, int digits);

}  // namespace stickslip::report::tools
