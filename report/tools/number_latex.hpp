// Balls as numbers in LaTeX formulas.
#pragma once

#include <string>

#include "core/ball.hpp"

namespace stickslip::report::tools {

// The rounded number as a factor: "1.5", "1.5\cdot 10^{-7}"; "(0.1 \pm 0.2)" where hardly anything is known.
[[nodiscard]] std::string latex_factor(const Ball& value, int digits);

// The same times what follows, with its sign, behind another term.
[[nodiscard]] std::string latex_term(const Ball& value, const std::string& times, int digits);

}  // namespace stickslip::report::tools
