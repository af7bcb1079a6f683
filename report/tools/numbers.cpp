#include "report/tools/numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::report::tools {

std::string readable(const BallText& ball, int digits) {
  if (ball.mid == "nan" || ball.rad == "inf") {
    return "unbounded";
  }
  const Rational mid = parse_decimal(ball.mid).value;
  const Rational rad = parse_decimal(ball.rad).value;
  return to_string(Ball::from_interval(mid - rad, mid + rad), digits);
}

int known_digits(const Ball& ball, int digits) {
  if (ball.is_exact()) {
    return digits;
  }
  const auto bits = static_cast<double>(arb_rel_accuracy_bits(ball.raw()));
  const double known = std::clamp(bits * std::log10(2.0), 0.0, static_cast<double>(digits));
  return std::clamp(static_cast<int>(known) + 2, 2, std::max(digits, 2));
}

std::string rounded(const Ball& ball, int digits) {
  if (!ball.is_finite()) {
    return "unbounded";
  }
  constexpr long bits_per_digit = 4;
  if (!ball.is_exact() && arb_rel_accuracy_bits(ball.raw()) < 2 * bits_per_digit) {
    return to_string(ball, 2);
  }
  const int sure = known_digits(ball, digits + 2) - 2;
  return to_text(ball, std::min(digits, std::max(sure, 1))).mid;
}

}  // namespace stickslip::report::tools
