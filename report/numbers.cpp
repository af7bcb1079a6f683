#include "report/numbers.hpp"

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::report {

std::string readable(const BallText& ball, int digits) {
  if (ball.mid == "nan" || ball.rad == "inf") {
    return "unbounded";
  }
  const Rational mid = parse_decimal(ball.mid).value;
  const Rational rad = parse_decimal(ball.rad).value;
  return to_string(Ball::from_interval(mid - rad, mid + rad), digits);
}

}  // namespace stickslip::report
