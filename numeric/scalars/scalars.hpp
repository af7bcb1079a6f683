// The scalars that numbers are computed with besides double: Arb balls for proofs, and jets over either for
// derivatives.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/ball.hpp"
#include "core/rational.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::numeric::scalars {

// The bits that `digits` significant digits need, with a few to spare.
[[nodiscard]] inline long bits_for(int digits) {
  return static_cast<long>(std::ceil(3.3219281 * digits)) + 16;
}

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
[[nodiscard]] inline double scalar<double>(const Rational& value) {
  return Ball(value).approximate();  // to nearest; GMP's own conversion cuts off
}
template <>
[[nodiscard]] inline Ball scalar<Ball>(const Rational& value) {
  return Ball(value);
}
template <>
[[nodiscard]] inline double pi<double>() {
  return std::numbers::pi;
}
template <>
[[nodiscard]] inline Ball pi<Ball>() {
  return Ball::pi();
}

// No member is below the first, or above the second; NaN or infinite where a ball is unbounded.
[[nodiscard]] inline std::pair<double, double> ends(const Ball& x) {
  return {arf_get_d(arb_midref(x.lower().raw()), ARF_RND_FLOOR),
          arf_get_d(arb_midref(x.upper().raw()), ARF_RND_CEIL)};
}
// All numbers from the first to the second are members; there may be none.
[[nodiscard]] inline std::pair<double, double> inner_ends(const Ball& x) {
  return {arf_get_d(arb_midref(x.lower().raw()), ARF_RND_CEIL),
          arf_get_d(arb_midref(x.upper().raw()), ARF_RND_FLOOR)};
}

// Not less than the distance of any x in [low, high] from a middle in there, whatever was rounded in finding
// that.
[[nodiscard]] inline double reach(double low, double middle, double high) {
  return std::nextafter(std::max(high - middle, middle - low), INFINITY);
}

// Of all members of a ball; 0 where that is not known.
template <class S>
[[nodiscard]] int sign_of(const S& x) {
  return x.is_positive() ? 1 : x.is_negative() ? -1 : 0;
}

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <>
struct NumTraits<stickslip::Ball> : stickslip::model::ScalarTraits<stickslip::Ball, 2, 40, 40> {};

}  // namespace Eigen
