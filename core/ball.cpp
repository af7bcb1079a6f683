#include "core/ball.hpp"

#include <fmt/format.h>

#include <memory>

#include "core/decimal.hpp"

namespace stickslip {
namespace {

std::string decimal_digits(const Ball& ball, int digits) {
  struct Free {
    void operator()(char * text) const { flint_free(text); }
  };
  const std::unique_ptr<char, Free> text(arb_get_str(ball.raw(), digits, ARB_STR_NO_RADIUS | ARB_STR_MORE));
  return text.get();
}

// Takes the zeros off the end of a decimal without exponent that has a point.
void trim_zeros(std::string& decimal) {
  if (decimal.find('.') == std::string::npos || decimal.find('e') != std::string::npos) {
    return;
  }
  decimal.erase(decimal.find_last_not_of('0') + 1);
  if (decimal.back() == '.') {
    decimal.pop_back();
  }
}

// An upper bound of |ball| as a decimal of three digits.
std::string decimal_bound(const Ball& ball) {
  const Ball bound = abs(ball).upper();
  if (!bound.is_positive()) {
    return "0";
  }
  const std::string rounded = decimal_digits(bound, 3);  // off by at most one unit of the third digit
  const Decimal decimal = parse_decimal(rounded);
  const Ball slack = Ball(decimal.value) - bound;
  if (!slack.is_negative() && !slack.contains_zero()) {
    return rounded;
  }
  return decimal_digits(bound * Ball(Rational(51, 50)), 3);
}

// Whether its decimal exponent is one that is read back (decimal.hpp).
bool has_common_size(const Ball& ball) {
  static const Ball largest = exp(Ball(20000));
  const Ball size = abs(ball);
  return is_zero(ball) ||
         ((largest - size).is_positive() && (size.upper() * largest - Ball(1)).is_positive());
}

}  // namespace

BallText to_text(const Ball& ball, int digits) {
  if (!ball.is_finite()) {
    return {"nan", "inf"};
  }
  const WorkingPrecision precision(std::max(WorkingPrecision::bits(), 4L * digits + 64));
  std::string mid = decimal_digits(ball, digits);
  if (!has_common_size(ball)) {  // of the digits all but the last are right
    mpz_class parts;             // of its size, the last digit but one
    mpz_ui_pow_ui(parts.get_mpz_t(), 10, static_cast<unsigned long>(std::max(digits, 2) - 2));
    const Ball slack = ball.radius() + abs(ball).upper() / Ball(Rational(parts));
    return {mid, decimal_digits(slack * Ball(Rational(51, 50)), 3)};
  }
  if (ball.is_exact()) {
    trim_zeros(mid);
  }
  return {mid, decimal_bound(ball - Ball(parse_decimal(mid).value))};
}

std::string to_string(const Ball& ball, int digits) {
  const BallText text = to_text(ball, digits);
  return text.rad == "0" ? text.mid : fmt::format("{} ± {}", text.mid, text.rad);
}

}  // namespace stickslip
