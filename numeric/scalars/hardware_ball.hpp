// Balls [mid ± rad] of two doubles, for bulk work: a hundred times as fast as Arb's at 64 bits, and as
// rigorous.
//
// Each operation rounds its midpoint to nearest and adds to the radius what that may have cost: at most 2^-53
// of the midpoint, or 2^-1074 where it underflows. Radii are sums of products of what is not negative, at
// most ten roundings deep, so a factor 1 + 2^-48 puts them above the exact ones. What is not a number, or
// infinite, contains everything and decides nothing. Assumes IEEE arithmetic rounded to nearest.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::scalars {

class HardwareBall {
 public:
  HardwareBall() = default;
  HardwareBall(int value) : mid_(value) {}     // NOLINT: scalars convert from int
  HardwareBall(double value) : mid_(value) {}  // NOLINT: exactly the double
  HardwareBall(double mid, double rad) : mid_(mid), rad_(rad) {}
  // Contains all members of the ball.
  explicit HardwareBall(const Ball& ball);
  // The numbers of at most this size; the bound is not negative.
  [[nodiscard]] static HardwareBall within(double bound) { return {0, bound}; }
  // Contains the same numbers, and perhaps more.
  [[nodiscard]] Ball ball() const;

  [[nodiscard]] double approximate() const { return mid_; }
  [[nodiscard]] double radius() const { return rad_; }
  [[nodiscard]] bool is_nonzero() const { return std::abs(mid_) > rad_ && rad_ < huge; }
  [[nodiscard]] bool is_positive() const { return mid_ > rad_ && rad_ < huge; }
  [[nodiscard]] bool is_negative() const { return -mid_ > rad_ && rad_ < huge; }
  [[nodiscard]] bool is_finite() const { return std::abs(mid_) < huge && rad_ < huge; }

  HardwareBall& operator+=(const HardwareBall& b) {
    mid_ += b.mid_;
    rad_ = above(rad_ + b.rad_ + rounding(mid_));
    return *this;
  }
  HardwareBall& operator-=(const HardwareBall& b) {
    mid_ -= b.mid_;
    rad_ = above(rad_ + b.rad_ + rounding(mid_));
    return *this;
  }
  HardwareBall& operator*=(const HardwareBall& b) {
    const double spread = std::abs(mid_) * b.rad_ + rad_ * (std::abs(b.mid_) + b.rad_);
    mid_ *= b.mid_;
    rad_ = above(spread + rounding(mid_));
    return *this;
  }
  // Of a divisor that may be zero: everything.
  HardwareBall& operator/=(const HardwareBall& b) {
    const double least = (std::abs(b.mid_) - b.rad_) * (1 - 0x1p-50);
    if (!(least > 0)) {
      return *this = everything();
    }
    const double quotient = mid_ / b.mid_;
    rad_ = above((rad_ + (std::abs(quotient) + 0x1p-1000) * b.rad_ * (1 + 0x1p-50)) / least +
                 rounding(quotient));
    mid_ = quotient;
    return *this;
  }
  friend HardwareBall operator+(HardwareBall a, const HardwareBall& b) { return a += b; }
  friend HardwareBall operator-(HardwareBall a, const HardwareBall& b) { return a -= b; }
  friend HardwareBall operator*(HardwareBall a, const HardwareBall& b) { return a *= b; }
  friend HardwareBall operator/(HardwareBall a, const HardwareBall& b) { return a /= b; }
  friend HardwareBall operator-(const HardwareBall& a) { return {-a.mid_, a.rad_}; }
  friend HardwareBall operator+(const HardwareBall& a) { return a; }

  [[nodiscard]] static HardwareBall everything() { return {0, INFINITY}; }

 private:
  // Beyond it nothing is decided, so no overflow is taken for a number.
  static constexpr double huge = 0x1p1000;

  // A number that exceeds the exact sum or product that `rad` is the rounded one of.
  [[nodiscard]] static double above(double rad) { return rad * (1 + 0x1p-48); }
  // A bound of the error of a rounded result.
  [[nodiscard]] static double rounding(double result) { return std::abs(result) * 0x1p-53 + 0x1p-1000; }

  double mid_ = 0;
  double rad_ = 0;
};

[[nodiscard]] inline bool is_zero(const HardwareBall& x) {
  return x.approximate() == 0 && x.radius() == 0;
}
[[nodiscard]] inline bool is_nonzero(const HardwareBall& x) {
  return x.is_nonzero();
}
// 1/x; exact for a power of two.
[[nodiscard]] inline HardwareBall inverse(const HardwareBall& x) {
  constexpr std::uint64_t fraction = (std::uint64_t{1} << 52U) - 1;
  const double size = std::abs(x.approximate());
  const bool is_exact = x.radius() == 0 && size > 0x1p-1000 && size < 0x1p1000 &&
                        (std::bit_cast<std::uint64_t>(size) & fraction) == 0;
  return is_exact ? HardwareBall(1 / x.approximate()) : HardwareBall(1) / x;
}
// sum += a x and sum += a x + b y, narrower and faster than one by one: each product and each sum may cost
// 2^-53 of what comes out, and all of it is added up and put above the exact sum once.
inline void add_product(HardwareBall& sum, const HardwareBall& a, const HardwareBall& x) {
  const double product = a.approximate() * x.approximate();
  const double mid = sum.approximate() + product;
  const double spread = sum.radius() + std::abs(a.approximate()) * x.radius() +
                        a.radius() * (std::abs(x.approximate()) + x.radius());
  const double rounded = (std::abs(product) + std::abs(mid)) * 0x1p-53 + 0x1p-1000;
  sum = {mid, (spread + rounded) * (1 + 0x1p-48)};
}
inline void add_products(HardwareBall& sum, const HardwareBall& a, const HardwareBall& x,
                         const HardwareBall& b, const HardwareBall& y) {
  const double ax = a.approximate() * x.approximate();
  const double by = b.approximate() * y.approximate();
  const double both = ax + by;
  const double mid = sum.approximate() + both;
  const double spread =
      sum.radius() +
      (std::abs(a.approximate()) * x.radius() + a.radius() * (std::abs(x.approximate()) + x.radius())) +
      (std::abs(b.approximate()) * y.radius() + b.radius() * (std::abs(y.approximate()) + y.radius()));
  const double rounded =
      ((std::abs(ax) + std::abs(by)) + (std::abs(both) + std::abs(mid))) * 0x1p-53 + 0x1p-1000;
  sum = {mid, (spread + rounded) * (1 + 0x1p-48)};
}

// (sin x, cos x), sin(x)/x and the derivative of that, for all members of x.
[[nodiscard]] std::pair<HardwareBall, HardwareBall> sin_cos(const HardwareBall& x);
[[nodiscard]] std::pair<HardwareBall, HardwareBall> sinc_and_slope(const HardwareBall& x);
// The same of two balls, which costs less where both have the same midpoint.
[[nodiscard]] std::array<std::pair<HardwareBall, HardwareBall>, 2> sin_cos(
    const std::array<HardwareBall, 2>& x);
[[nodiscard]] std::array<std::pair<HardwareBall, HardwareBall>, 2> sinc_and_slope(
    const std::array<HardwareBall, 2>& x);
[[nodiscard]] inline HardwareBall sinc(const HardwareBall& x) {
  return sinc_and_slope(x).first;
}
[[nodiscard]] inline HardwareBall sinc_slope(const HardwareBall& x) {
  return sinc_and_slope(x).second;
}
// Of a ball that reaches below zero: everything.
[[nodiscard]] HardwareBall sqrt(const HardwareBall& x);
[[nodiscard]] inline HardwareBall sin(const HardwareBall& x) {
  return sin_cos(x).first;
}
[[nodiscard]] inline HardwareBall cos(const HardwareBall& x) {
  return sin_cos(x).second;
}

// A ball that contains every common member; nothing when there is none.
[[nodiscard]] std::optional<HardwareBall> intersection(const HardwareBall& a, const HardwareBall& b);

// GMP's double lies less than a place from the number; small whole numbers are exact.
template <>
[[nodiscard]] inline HardwareBall scalar<HardwareBall>(const Rational& value) {
  const double near = value.get_d();
  const bool is_exact = value.get_den() == 1 && std::abs(near) < 0x1p53;
  return {near, is_exact ? 0 : std::abs(near) * 0x1p-52 + 0x1p-1000};
}
template <>
[[nodiscard]] inline HardwareBall pi<HardwareBall>() {
  return {0x1.921fb54442d18p+1, 0x1p-52};
}

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <>
struct NumTraits<stickslip::numeric::scalars::HardwareBall>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::HardwareBall, 2, 4, 8> {};

}  // namespace Eigen
