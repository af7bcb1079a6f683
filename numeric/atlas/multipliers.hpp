// Whether all multipliers of a motion lie inside the unit circle, by the coefficients of their polynomial:
// over any scalar with enclosures, without the multipliers.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/motion/multipliers.hpp"

namespace stickslip::numeric::atlas {

// The coefficients of motion/multipliers.hpp over the leading one, which is left out.
template <class T>
[[nodiscard]] std::vector<T> characteristic_polynomial(const motion::MotionOf<T>& motion) {
  std::vector<T> c = motion::multiplier_polynomial<T>(motion);
  const T leading = c.back();
  c.pop_back();
  if (c.size() == 3) {  // with a stick; else it is 1
    for (T& coefficient : c) {
      coefficient = coefficient / leading;
    }
  }
  return c;
}

// Proved: all zeros of x^n + … + c[0] have |x| < 1. Refuted: one has |x| > 1. Both for every member; T has a
// member `over`, its enclosure.
//
// By p(1) < 0 and (-1)^n p(-1) < 0, each of which means a real zero beyond; then by Schur and Cohn: with
// k = p(0), the polynomial (p(x) - k x^n p(1/x))/(x (1 - k²)) of degree n - 1 has as many zeros outside the
// circle as p, provided |k| < 1; and |k| > 1 is the product of the moduli of all zeros.
template <class T>
[[nodiscard]] Truth is_inside_unit_circle(std::vector<T> c) {
  const auto less_than_one = [](const T& k) {
    const T rest = T(1) - k * k;
    return rest.over.is_positive()   ? Truth::proved
           : rest.over.is_negative() ? Truth::refuted
                                     : Truth::undecided;
  };
  T at_one(1);
  T at_minus_one(1);
  for (std::size_t i = c.size(); i-- > 0;) {
    at_one += c[i];
    at_minus_one = c[i] - at_minus_one;
  }
  if (c.size() % 2 == 1) {
    at_minus_one = -at_minus_one;
  }
  if (at_one.over.is_negative() || at_minus_one.over.is_negative()) {
    return Truth::refuted;
  }
  while (!c.empty()) {
    const T k = c.front();
    const Truth here = less_than_one(k);
    if (here != Truth::proved) {
      return here;
    }
    const std::size_t n = c.size();
    const T rest = T(1) - k * k;
    std::vector<T> reduced;
    for (std::size_t i = 1; i < n; ++i) {
      reduced.push_back((c[i] - k * c[n - i]) / rest);
    }
    c = std::move(reduced);
  }
  return Truth::proved;
}

}  // namespace stickslip::numeric::atlas
