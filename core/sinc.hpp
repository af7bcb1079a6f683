// sinc(x) = sin(x)/x with sinc(0) = 1, and its derivative, for every numeric scalar: the entire functions
// that remain when factors of a duration are divided out of a closing equation.
#pragma once

#include <utility>

#include "core/ball.hpp"

namespace stickslip {

// As model::sinc.
[[nodiscard]] double sinc(double x);
[[nodiscard]] double sinc_slope(double x);
[[nodiscard]] Ball sinc(const Ball& x);
// Contains (cos x - sinc x)/x for every member, also where x contains 0.
[[nodiscard]] Ball sinc_slope(const Ball& x);

// (sin x, cos x).
[[nodiscard]] std::pair<double, double> sin_cos(double x);
[[nodiscard]] std::pair<Ball, Ball> sin_cos(const Ball& x);

}  // namespace stickslip
