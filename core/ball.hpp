// Balls, and balls as text.
#pragma once

#include <string>

#include "core/ball_arithmetic.hpp"

namespace stickslip {

// A ball as decimal text: every member of the ball lies within [mid - rad, mid + rad].
struct BallText {
  std::string mid;
  std::string rad;
};

// The midpoint to at most `digits` significant digits, and a radius that covers the rounding too. An
// unbounded or indeterminate ball gives {"nan", "inf"}.
[[nodiscard]] BallText to_text(const Ball& ball, int digits = 20);

// The same for a reader, "1.0609 ± 3.1e-20".
[[nodiscard]] std::string to_string(const Ball& ball, int digits = 20);

// Whether the ball is exactly zero: then products with it need not be computed.
[[nodiscard]] inline bool is_zero(const Ball& x) {
  return arb_is_zero(x.raw()) != 0;
}
// Whether no member is zero: then one can divide by it.
[[nodiscard]] inline bool is_nonzero(const Ball& x) {
  return x.is_nonzero();
}

// sum += a b and sum -= a b without a temporary.
inline void add_product(Ball& sum, const Ball& a, const Ball& b) {
  arb_addmul(sum.raw(), a.raw(), b.raw(), WorkingPrecision::bits());
}
inline void subtract_product(Ball& sum, const Ball& a, const Ball& b) {
  arb_submul(sum.raw(), a.raw(), b.raw(), WorkingPrecision::bits());
}

}  // namespace stickslip
