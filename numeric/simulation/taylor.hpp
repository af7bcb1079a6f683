// A function on [0, 1] as a Taylor polynomial at 0, and how far it certainly stays positive. Up to rounding:
// what the polynomial leaves out is below it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::numeric::simulation {

// Steps of at most this angle of the fastest motion leave out angle^(order + 1)/(order + 1)! < 2e-16.
inline constexpr int order = 15;
inline constexpr double step_angle = 0.7;

using Series = std::array<double, order + 1>;

// A function is c0 + c1 t + c2 t² + c3 t³ within rest t⁴.
struct Cubic {
  std::array<double, 4> c{};
  double rest = 0;
};

// What the terms from the fourth order on are at most about any point of [0, 1], beyond it and within [0, 1],
// as a multiple of t⁴: a bound of the fourth derivative over 24.
[[nodiscard]] inline double rest(const Series& g) {
  double sum = 0;
  for (std::size_t k = 4; k <= order; ++k) {
    const auto n = static_cast<double>(k);
    sum += n * (n - 1) * (n - 2) * (n - 3) / 24 * std::abs(g[k]);
  }
  return sum;
}

// About a point a of [0, 1], with the rest from below.
[[nodiscard]] inline Cubic cubic_at(const Series& g, double a, double rest) {
  if (a == 0) {
    return {{g[0], g[1], g[2], g[3]}, rest};
  }
  Cubic result{{}, rest};
  auto& [c0, c1, c2, c3] = result.c;
  for (std::size_t k = order + 1; k-- > 0;) {
    c3 = c3 * a + c2;
    c2 = c2 * a + c1;
    c1 = c1 * a + c0;
    c0 = c0 * a + g[k];
  }
  return result;
}

// A lower bound on [0, h]: the least Bernstein coefficient of the cubic, less the rest.
[[nodiscard]] inline double least(const Cubic& g, double h) {
  const double b0 = g.c[0];
  const double d1 = g.c[1] * h / 3;
  const double d2 = g.c[2] * h * h / 3;
  const double b1 = b0 + d1;
  const double b2 = b1 + d1 + d2;
  const double b3 = b0 + 3 * (d1 + d2) + g.c[3] * h * h * h;
  return std::min(std::min(b0, b1), std::min(b2, b3)) - g.rest * (h * h * h * h);
}

// A polynomial k0 + k1 t + … + k4 t⁴ whose second derivative is concave: its minimum is at an end.
using Quartic = std::array<double, 5>;

// A lower bound of g(t)/t^zeros, where the coefficients of g below `zeros` are exactly zero; zeros from 0
// to 3.
[[nodiscard]] inline Quartic lower_bound(const Cubic& g, int zeros) {
  const Quartic all{g.c[0], g.c[1], g.c[2], g.c[3], -g.rest};
  Quartic k{};
  for (std::size_t i = static_cast<std::size_t>(zeros); i < 5; ++i) {
    k[i - static_cast<std::size_t>(zeros)] = all[i];
  }
  return k;
}

// A time t <= h, as late as a few iterations find, such that the polynomial is positive on [0, t), given that
// it is at 0; h when it is positive on all of [0, h). With a lower bound m of the second derivative on [a, h]
// it is positive until the first root of p(a) + p'(a) d + m d²/2: those times increase to the first root,
// quadratically when it is simple. Up to rounding; values up to `zero` are taken for zero.
[[nodiscard]] inline double positive_until(const Quartic& k, double h, double zero) {
  constexpr int most = 40;
  constexpr double enough = 1e-2;
  const auto second = [&k](double t) { return 2 * k[2] + t * (6 * k[3] + t * 12 * k[4]); };
  const double at_end = second(h);
  double a = 0;
  for (int i = 0; i < most; ++i) {
    const double p = k[0] + a * (k[1] + a * (k[2] + a * (k[3] + a * k[4])));
    const double slope = k[1] + a * (2 * k[2] + a * (3 * k[3] + a * 4 * k[4]));
    if (!(p > zero)) {
      break;
    }
    const double m = std::min(second(a), at_end);
    const double discriminant = slope * slope - 2 * m * p;
    if (discriminant < 0 || (m >= 0 && slope >= 0)) {
      return h;
    }
    const double step = 2 * p / (std::sqrt(discriminant) - slope);
    a += step;
    if (!(a < h)) {
      return h;
    }
    // Where the quartic says no more than the function's bound, nearer roots of it are of no use.
    if (step < enough * a && i > 0 && !(-k[4] * a * a * a * a < zero)) {
      break;
    }
  }
  return a;
}

}  // namespace stickslip::numeric::simulation
