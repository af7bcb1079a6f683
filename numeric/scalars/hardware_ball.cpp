#include "numeric/scalars/hardware_ball.hpp"

#include <algorithm>
#include <array>

namespace stickslip::numeric::scalars {
namespace {

// What the point functions below are off by at most. All that they compute with is at most 1 in size but for
// the argument, whose reduction is exact up to 2^-51; they round less than thirty times.
constexpr double error = 0x1p-47;
constexpr double largest_argument = 0x1p19;

// pi/2 as a sum; the first two have 33 bits, so a whole number below 2^20 times them is exact. The rest is
// less than 2^-100.
constexpr double half_pi_1 = 0x1.921fb544p+0;
constexpr double half_pi_2 = 0x1.0b4611a6p-34;
constexpr double half_pi_3 = 0x1.3198a2e037073p-69;

// sum of c[k] q^k.
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double q) {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) {
    sum = c[k] + q * sum;
  }
  return sum;
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
  const double turns = std::nearbyint(x * 0x1.45f306dc9c883p-1);
  const double r = ((x - turns * half_pi_1) - turns * half_pi_2) - turns * half_pi_3;
  const double s = small_sine(r);
  const double c = small_cosine(r);
  switch (static_cast<long>(turns) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
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

}  // namespace

HardwareBall::HardwareBall(const Ball& ball) : mid_(arf_get_d(arb_midref(ball.raw()), ARF_RND_NEAR)) {
  arf_t rad;
  arf_init(rad);
  arf_set_mag(rad, arb_radref(ball.raw()));
  rad_ = above(arf_get_d(rad, ARF_RND_CEIL) + rounding(mid_));
  arf_clear(rad);
  if (arf_cmp_d(arb_midref(ball.raw()), mid_) == 0 && mag_is_zero(arb_radref(ball.raw())) != 0) {
    rad_ = 0;
  }
  if (!is_finite()) {
    *this = everything();
  }
}

Ball HardwareBall::ball() const {
  Ball result;
  if (!is_finite()) {
    arb_indeterminate(result.raw());
    return result;
  }
  arb_set_d(result.raw(), mid_);
  mag_set_d(arb_radref(result.raw()), rad_);
  return result;
}

std::pair<HardwareBall, HardwareBall> sin_cos(const HardwareBall& x) {
  if (!is_reducible(x)) {
    return {{0, 1}, {0, 1}};
  }
  const auto [s, c] = at_point(x.approximate());
  return {around(s, c, 1, x.radius()), around(c, s, 1, x.radius())};
}

// |d^k sinc| <= 1/(k + 1), for sinc(x) is the mean of cos(x t) over 0 < t < 1.
HardwareBall sinc(const HardwareBall& x) {
  if (!is_reducible(x)) {
    return {0, 1};
  }
  const auto [value, slope] = sinc_at_point(x.approximate());
  HardwareBall result = around(value, std::abs(slope) + 8 * error, 1.0 / 3 + error, x.radius());
  return result + HardwareBall(0, 4 * error);
}
HardwareBall sinc_slope(const HardwareBall& x) {
  if (!is_reducible(x)) {
    return {0, 0.5};
  }
  const double slope = sinc_at_point(x.approximate()).second;
  return HardwareBall(slope, 8 * error) + HardwareBall(0, (1.0 / 3 + error) * x.radius());
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
  const HardwareBall distance = HardwareBall(a.approximate()) - HardwareBall(b.approximate());
  const HardwareBall reach = HardwareBall(a.radius()) + HardwareBall(b.radius());
  if ((distance - reach).is_positive() || (distance + reach).is_negative()) {
    return std::nullopt;
  }
  // The ends, rounded outwards, and the ball around both.
  const auto outwards = [](double end, double sign) {
    return end + sign * (std::abs(end) * 0x1p-52 + 0x1p-1000);
  };
  const double low =
      std::max(outwards(a.approximate() - a.radius(), -1), outwards(b.approximate() - b.radius(), -1));
  const double high =
      std::min(outwards(a.approximate() + a.radius(), 1), outwards(b.approximate() + b.radius(), 1));
  const double mid = low + (high - low) / 2;
  const double rad = std::max({high - mid, mid - low, 0.0});
  return HardwareBall(mid, rad + std::abs(mid) * 0x1p-52 + 0x1p-1000) + HardwareBall(0, rad * 0x1p-50);
}

}  // namespace stickslip::numeric::scalars
