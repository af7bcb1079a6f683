#include "numeric/scalars/scalars.hpp"

#include <cmath>
#include <numbers>

namespace stickslip::numeric::scalars {

long bits_for(int digits) {
  return static_cast<long>(std::ceil(3.3219281 * digits)) + 16;
}

template <>
double scalar<double>(const Rational& value) {
  return Ball(value).approximate();  // to nearest; GMP's own conversion cuts off
}
template <>
Ball scalar<Ball>(const Rational& value) {
  return Ball(value);
}
template <>
double pi<double>() {
  return std::numbers::pi;
}
template <>
Ball pi<Ball>() {
  return Ball::pi();
}

}  // namespace stickslip::numeric::scalars
