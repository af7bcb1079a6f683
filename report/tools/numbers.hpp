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

// So many significant digits of a number that is not above, and not below x.
[[nodiscard]] std::string below(double x, int digits);
[[nodiscard]] std::string above(double x, int digits);

// Balls as numbers in LaTeX formulas.

// The rounded number as a factor: "1.5", "1.5\cdot 10^{-7}"; "(0.1 \pm 0.2)" where hardly anything is known.
[[nodiscard]] std::string latex_factor(const Ball& value, int digits);

// The same times what follows, with its sign, behind another term.
[[nodiscard]] std::string latex_term(const Ball& value, const std::string& times, int digits);

}  // namespace stickslip::report::tools
