#include "numeric/scalars/hardware_ball.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace stickslip::numeric::scalars {
namespace {

// What the point functions below are off by at most. All that they compute with is at most 1 in size except
// for the argument, whose reduction is exact up to 2^-51; they round less than thirty times.
constexpr double error = 0x1p-47;
constexpr double largest_argument = 0x1p19;

// pi/2 as a sum; the first two have 33 bits, so a whole number below 2^20 times them is exact. The rest is
// less than 2^-100.
constexpr double half_pi_1 = 0x1.921fb544p+0;
constexpr double half_pi_2 = 0x1.0b4611a6p-34;
constexpr double half_pi_3 = 0x1.3198a2e037073p-69;

// sum of c[k] q^k: not Horner's scheme, so that what does not depend on each other is computed at once.
double polynomial(const std::array<double, 8>& c, double q) {
  const double q2 = q * q;
  const double low = (c[0] + c[1] * q) + (c[2] + c[3] * q) * q2;
  const double high = (c[4] + c[5] * q) + (c[6] + c[7] * q) * q2;
  return low + high * (q2 * q2);
}

// Taylor's polynomials for |x| < 0.8, where the first term left out is below 2^-58: (sinc x - 1)/x² and (cos
// x
// - 1)/x² in q = x².
constexpr std::array sinc_series{-1 / 6.0,        1 / 120.0,        -1 / 5040.0,       1 / 362880.0,
                                 -1 / 39916800.0, 1 / 6227020800.0, -1 / 1307674368e3, 1 / 355687428096e3};
constexpr std::array cosine_series{-1 / 2.0,       1 / 24.0,        -1 / 720.0,         1 / 40320.0,
                                   -1 / 3628800.0, 1 / 479001600.0, -1 / 87178291200.0, 1 / 20922789888e3};
// Of sinc', divided by x: (-1)^(k+1)/((2k+1)! (2k + 3)).
constexpr std::array slope_series{-1 / 3.0,       1 / 30.0,        -1 / 840.0,      1 / 45360.0,
                                  -1 / 3991680.0, 1 / 518918400.0, -1 / 93405312e3, 1 / 22230464256e3};

double small_sine(double x) {
  const double q = x * x;
  return x + x * q * polynomial(sinc_series, q);
}
double small_cosine(double x) {
  const double q = x * x;
  return 1 + q * polynomial(cosine_series, q);
}

// (sin x, cos x) off by at most `error`, for |x| <= largest_argument.
std::pair<double, double> at_point(double x) {
  // Next to `shift` doubles are whole numbers, of which the last bits are those of the nearest to x/(pi/2).
  constexpr double shift = 0x1.8p52;
  const double shifted = x * 0x1.45f306dc9c883p-1 + shift;
  const double turns = shifted - shift;
  const double r = ((x - turns * half_pi_1) - turns * half_pi_2) - turns * half_pi_3;
  const double s = small_sine(r);
  const double c = small_cosine(r);
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const auto with_sign = [](double value, std::uint64_t is_negative) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ (is_negative << 63U));
  };
  const bool odd = (quadrant & 1U) != 0;
  return {with_sign(odd ? c : s, quadrant >> 1U & 1U), with_sign(odd ? s : c, (quadrant + 1) >> 1U & 1U)};
}

// f(m ± r) for f with |f'(m)| <= slope up to `error`, |f''| <= curvature, both at most 1.
HardwareBall around(double value, double slope, double curvature, double r) {
  const double steps = std::min((std::abs(slope) + error) * r + curvature / 2 * r * r, r);
  return {value, (steps + error) * (1 + 0x1p-48)};
}

bool is_reducible(const HardwareBall& x) {
  return std::abs(x.approximate()) <= largest_argument && x.radius() <= largest_argument;
}

// Off by at most four times `error`: what is divided by is at least 1/2.
std::pair<double, double> sinc_at_point(double x) {
  if (std::abs(x) <= 0.5) {
    const double q = x * x;
    return {1 + q * polynomial(sinc_series, q), x * polynomial(slope_series, q)};
  }
  const auto [s, c] = at_point(x);
  const double inverse = 1 / x;
  const double value = s * inverse;
  return {value, (c - value) * inverse};
}

std::pair<HardwareBall, HardwareBall> sin_cos_around(const std::pair<double, double>& at, double r) {
  return {around(at.first, at.second, 1, r), around(at.second, at.first, 1, r)};
}

// |d^k sinc| <= 1/(k + 1), for sinc(x) is the mean of cos(x t) over 0 < t < 1; and -x sinc''(x) = (1 - 2/x²)
// sin x + (2/x) cos x is at most √(1 + 4/x⁴) in size, less than 1.03 for |x| > 3.05, where that says more.
std::pair<HardwareBall, HardwareBall> sinc_around(const std::pair<double, double>& at,
                                                  const HardwareBall& x) {
  const auto& [value, slope] = at;
  const double r = x.radius();
  const double least = std::max(std::abs(x.approximate()) - r, 1.0);
  const double curvature = std::min(1.0 / 3 + error, 1.03 / least);
  return {around(value, std::abs(slope) + 8 * error, curvature, r) + HardwareBall(0, 4 * error),
          HardwareBall(slope, 8 * error) + HardwareBall(0, curvature * r)};
}

}  // namespace

HardwareBall::HardwareBall(const Ball& ball)
    : mid_(arf_get_d(arb_midref(ball.raw()), ARF_RND_NEAR)),
      rad_(above(mag_get_d(arb_radref(ball.raw())) + rounding(mid_))) {
  if (arf_cmp_d(arb_midref(ball.raw()), mid_) == 0 && mag_is_zero(arb_radref(ball.raw())) != 0) {
    rad_ = 0;
  }
  if (!is_finite()) {
    *this = everything();
  }
}

Ball HardwareBall::ball() const {
  if (!is_finite()) {
    return anything();
  }
  Ball result;
  arb_set_d(result.raw(), mid_);
  mag_set_d(arb_radref(result.raw()), rad_);
  return result;
}

std::pair<HardwareBall, HardwareBall> sin_cos(const HardwareBall& x) {
  return is_reducible(x) ? sin_cos_around(at_point(x.approximate()), x.radius())
                         : std::pair<HardwareBall, HardwareBall>{{0, 1}, {0, 1}};
}

std::array<std::pair<HardwareBall, HardwareBall>, 2> sin_cos(const std::array<HardwareBall, 2>& x) {
  if (x[0].approximate() != x[1].approximate() || !is_reducible(x[0]) || !is_reducible(x[1])) {
    return {sin_cos(x[0]), sin_cos(x[1])};
  }
  const auto at = at_point(x[0].approximate());
  return {sin_cos_around(at, x[0].radius()), sin_cos_around(at, x[1].radius())};
}

std::pair<HardwareBall, HardwareBall> sinc_and_slope(const HardwareBall& x) {
  return is_reducible(x) ? sinc_around(sinc_at_point(x.approximate()), x)
                         : std::pair<HardwareBall, HardwareBall>{{0, 1}, {0, 0.5}};
}

std::array<std::pair<HardwareBall, HardwareBall>, 2> sinc_and_slope(const std::array<HardwareBall, 2>& x) {
  if (x[0].approximate() != x[1].approximate() || !is_reducible(x[0]) || !is_reducible(x[1])) {
    return {sinc_and_slope(x[0]), sinc_and_slope(x[1])};
  }
  const auto at = sinc_at_point(x[0].approximate());
  return {sinc_around(at, x[0]), sinc_around(at, x[1])};
}

// |√x - √m| = |x - m|/(√x + √m), largest for the least x; std::sqrt rounds to nearest.
HardwareBall sqrt(const HardwareBall& x) {
  const double least = (x.approximate() - x.radius()) * (1 - 0x1p-50);
  if (!(least > 0) || !x.is_finite()) {
    return HardwareBall::everything();
  }
  const double root = std::sqrt(x.approximate());
  return HardwareBall(root, x.radius() / (root + std::sqrt(least)) * (1 + 0x1p-48)) +
         HardwareBall(0, root * 0x1p-52);
}

std::optional<HardwareBall> intersection(const HardwareBall& a, const HardwareBall& b) {
  if (!a.is_finite() || !b.is_finite()) {
    return a.is_finite() ? a : b;
  }
  // The ends, rounded outwards, and the ball around both.
  const auto outwards = [](double end, double sign) {
    return end + sign * (std::abs(end) * 0x1p-52 + 0x1p-1000);
  };
  const double low =
      std::max(outwards(a.approximate() - a.radius(), -1), outwards(b.approximate() - b.radius(), -1));
  const double high =
      std::min(outwards(a.approximate() + a.radius(), 1), outwards(b.approximate() + b.radius(), 1));
  if (low > high) {
    return std::nullopt;
  }
  const double mid = low + (high - low) / 2;
  return HardwareBall(mid, std::max(high - mid, mid - low) * (1 + 0x1p-50));
}

}  // namespace stickslip::numeric::scalars
