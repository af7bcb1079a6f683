#include "core/ball.hpp"

#include <fmt/format.h>

#include <memory>

#include "core/decimal.hpp"
#include "core/fmpq.hpp"

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

}  // namespace

constinit thread_local long WorkingPrecision::bits_ = 128;

WorkingPrecision::WorkingPrecision(long bits) : previous_(bits_) {
  bits_ = bits;
}
WorkingPrecision::~WorkingPrecision() {
  bits_ = previous_;
}

Ball::Ball(const Rational& value) : Ball() {
  arb_set_fmpq(value_, Fmpq(value).raw(), WorkingPrecision::bits());
}

Ball Ball::from_interval(const Rational& lower, const Rational& upper) {
  return hull(Ball(lower), Ball(upper));
}

Ball Ball::hull(const Ball& a, const Ball& b) {
  Ball result;
  arb_union(result.value_, a.value_, b.value_, WorkingPrecision::bits());
  return result;
}

Ball Ball::pi() {
  Ball result;
  arb_const_pi(result.value_, WorkingPrecision::bits());
  return result;
}

bool Ball::contains(const Rational& q) const {
  return arb_contains_fmpq(value_, Fmpq(q).raw()) != 0;
}

Ball Ball::midpoint() const {
  Ball result;
  arb_get_mid_arb(result.value_, value_);
  return result;
}

Ball Ball::radius() const {
  Ball result;
  arb_get_rad_arb(result.value_, value_);
  return result;
}

Ball Ball::lower() const {
  Ball result;
  arb_get_lbound_arf(arb_midref(result.value_), value_, WorkingPrecision::bits());
  return result;
}

Ball Ball::upper() const {
  Ball result;
  arb_get_ubound_arf(arb_midref(result.value_), value_, WorkingPrecision::bits());
  return result;
}

double Ball::approximate() const {
  return arf_get_d(arb_midref(value_), ARF_RND_NEAR);
}

BallText to_text(const Ball& ball, int digits) {
  if (!ball.is_finite()) {
    return {"nan", "inf"};
  }
  const WorkingPrecision precision(std::max(WorkingPrecision::bits(), 4L * digits + 64));
  std::string mid = decimal_digits(ball, digits);
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
