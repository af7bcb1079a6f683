// Balls for readers.
#pragma once

#include <optional>
#include <string>

#include "core/ball.hpp"
#include "core/decimal.hpp"

namespace stickslip::report::tools {

// The ball with its midpoint to at most `digits` significant digits: "7.7492 ± 4.0e-5". An unbounded ball
// reads "unbounded".
[[nodiscard]] std::string readable(const Ball& ball, int digits);

// The value with as many decimals as are printed, "7.750" beside "7.749"; none where the ball leaves that
// open.
[[nodiscard]] std::optional<std::string> rounded_like(const Decimal& printed, const Ball& value);

// The digits that are worth printing: at most `digits`, and not many more than the ball knows; at least 2.
[[nodiscard]] int known_digits(const Ball& ball, int digits);

// A decimal without radius: at most `digits` significant digits, each of them right to one unit of the last
// one; a ball that knows fewer than 2 digits reads "mid ± rad", an unbounded one "unbounded".
[[nodiscard]] std::string rounded(const Ball& ball, int digits);

}  // namespace stickslip::report::tools
