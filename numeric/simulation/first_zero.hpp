// How far a function certainly stays positive, from its derivatives at one point and a bound of the fourth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::numeric::simulation {

// g and its first three derivatives at the beginning of a step; |g''''| <= bound on the whole step.
struct Expansion {
  std::array<double, 4> derivative{};
  double bound = 0;
};

// A polynomial k0 + k1 t + … + k4 t⁴ whose second derivative is concave: its minimum is at an end.
using Quartic = std::array<double, 5>;

// The lower Taylor polynomial of g(t)/t^order on [0, h], where the derivatives of g below `order` are exactly
// zero; order 0 to 3.
[[nodiscard]] inline Quartic lower_bound(const Expansion& g, int order) {
  const Quartic all{g.derivative[0], g.derivative[1], g.derivative[2] / 2, g.derivative[3] / 6,
                    -g.bound / 24};
  Quartic k{};
  for (std::size_t i = static_cast<std::size_t>(order); i < 5; ++i) {
    k[i - static_cast<std::size_t>(order)] = all[i];
  }
  return k;
}

// Bounds of the cubic Taylor polynomial of g on [0, h]: the least and the greatest Bernstein coefficient,
// moved apart by the bound of the rest.
[[nodiscard]] inline std::array<double, 2> bounds(const Expansion& g, double h) {
  const double b0 = g.derivative[0];
  const double d1 = g.derivative[1] * h / 3;
  const double d2 = g.derivative[2] * h * h / 6;
  const double b1 = b0 + d1;
  const double b2 = b1 + d1 + d2;
  const double b3 = b0 + 3 * (d1 + d2) + g.derivative[3] * h * h * h / 6;
  const double rest = g.bound * h * h * h * h / 24;
  return {std::min(std::min(b0, b1), std::min(b2, b3)) - rest,
          std::max(std::max(b0, b1), std::max(b2, b3)) + rest};
}

// A time t <= h, as late as a few iterations find, such that the polynomial is positive on [0, t), given that
// it is at 0; h when it is positive on all of [0, h). With a lower bound m of the second derivative on [a, h]
// it is positive until the first root of p(a) + p'(a) d + m d²/2: those times increase to the first root,
// quadratically when it is simple. Up to rounding.
[[nodiscard]] inline double positive_until(const Quartic& k, double h) {
  constexpr int most = 40;
  constexpr double enough = 1e-2;
  const auto second = [&k](double t) { return 2 * k[2] + t * (6 * k[3] + t * 12 * k[4]); };
  const double at_end = second(h);
  double a = 0;
  for (int i = 0; i < most; ++i) {
    const double p = k[0] + a * (k[1] + a * (k[2] + a * (k[3] + a * k[4])));
    const double slope = k[1] + a * (2 * k[2] + a * (3 * k[3] + a * 4 * k[4]));
    if (!(p > 0)) {
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
    if (step < enough * a && i > 0) {
      break;
    }
  }
  return a;
}

}  // namespace stickslip::numeric::simulation
