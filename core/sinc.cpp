#include "core/sinc.hpp"

#include <cmath>

namespace stickslip {
namespace {

// The members of x in absolute value are at most 1/2 (decided, never guessed).
bool is_small(const Ball& x) {
  return (abs(x) - Ball(0.5)).is_negative();
}

// -x/3 + x³/30 - …: the terms (-1)^(k+1) x^(2k+1) / ((2k+1)! (2k+3)), alternating and decreasing for |x| <=
// 1, so the tail is bounded by the first term left out.
Ball slope_series(const Ball& x) {
  const Ball square = x * x;
  const Ball smallest = [&] {
    Ball power(1);
    arb_mul_2exp_si(power.raw(), power.raw(), -WorkingPrecision::bits() - 8);
    return power;
  }();
  Ball sum(0);
  Ball power = -x;  // (-1)^(k+1) x^(2k+1)/(2k+1)!
  for (long k = 0;; ++k) {
    const Ball term = power / Ball(2 * k + 3);
    if ((abs(term) - smallest).is_negative()) {
      const Ball bound = abs(term).upper();
      return sum + Ball::hull(-bound, bound);
    }
    sum += term;
    power = -power * square / Ball((2 * k + 2) * (2 * k + 3));
  }
}

}  // namespace

double sinc(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

double sinc_slope(double x) {
  if (std::abs(x) < 1e-2) {
    return -x / 3 + x * x * x / 30 - x * x * x * x * x / 840;
  }
  return (std::cos(x) - sinc(x)) / x;
}

Ball sinc(const Ball& x) {
  Ball result;
  arb_sinc(result.raw(), x.raw(), WorkingPrecision::bits());
  return result;
}

Ball sinc_slope(const Ball& x) {
  if (is_small(x)) {
    return slope_series(x);
  }
  if (x.contains_zero()) {
    return Ball::from_interval(Rational(-437, 1000), Rational(437, 1000));  // |sinc'| < 0.4362 everywhere
  }
  return (cos(x) - sinc(x)) / x;
}

std::pair<double, double> sin_cos(double x) {
  return {std::sin(x), std::cos(x)};
}

std::pair<Ball, Ball> sin_cos(const Ball& x) {
  std::pair<Ball, Ball> result;
  arb_sin_cos(result.first.raw(), result.second.raw(), x.raw(), WorkingPrecision::bits());
  return result;
}

}  // namespace stickslip
