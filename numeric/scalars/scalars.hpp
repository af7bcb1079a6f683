// The scalars that numbers are computed with besides double: Arb balls for proofs, and jets over either for
// derivatives.
#pragma once

#include "core/ball.hpp"
#include "core/rational.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::numeric::scalars {

// The bits that `digits` significant digits need, with a few to spare.
[[nodiscard]] long bits_for(int digits);

// sum += a b and sum -= a b without a temporary.
inline void add_product(double& sum, double a, double b) {
  sum += a * b;
}
inline void subtract_product(double& sum, double a, double b) {
  sum -= a * b;
}

// All numbers that are no larger than some member, in size.
[[nodiscard]] inline Ball within(const Ball& size) {
  const Ball most = abs(size).upper();
  return Ball::hull(-most, most);
}
// Decides nothing.
[[nodiscard]] inline Ball anything() {
  Ball unknown;
  arb_indeterminate(unknown.raw());
  return unknown;
}

// An exact number and pi as scalars of one kind; balls take the working precision.
template <class S>
[[nodiscard]] S scalar(const Rational& value);
template <class S>
[[nodiscard]] S pi();

template <>
[[nodiscard]] double scalar<double>(const Rational& value);
template <>
[[nodiscard]] Ball scalar<Ball>(const Rational& value);
template <>
[[nodiscard]] double pi<double>();
template <>
[[nodiscard]] Ball pi<Ball>();

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <>
struct NumTraits<stickslip::Ball> : stickslip::model::ScalarTraits<stickslip::Ball, 2, 40, 40> {};

}  // namespace Eigen
