// Whether all eigenvalues of a matrix lie inside the unit circle, by the coefficients of its characteristic
// polynomial: over any scalar with enclosures, without the eigenvalues.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include "core/verdict.hpp"

namespace stickslip::numeric::atlas {

// x^n + c[n-1] x^(n-1) + … + c[0] of an n by n matrix, by Faddeev and LeVerrier.
template <class T, int n>
[[nodiscard]] std::vector<T> characteristic_polynomial(const Eigen::Matrix<T, n, n>& M) {
  using Matrix = Eigen::Matrix<T, n, n>;
  std::vector<T> c(static_cast<std::size_t>(n));
  const auto times = [](const Matrix& a, const Matrix& b) { return Matrix(a.lazyProduct(b)); };
  Matrix A = M;
  for (int k = 1; k <= n; ++k) {
    T trace(0);
    for (int i = 0; i < n; ++i) {
      trace += A(i, i);
    }
    const T here = -trace / T(k);
    c[static_cast<std::size_t>(n - k)] = here;
    for (int i = 0; i < n; ++i) {
      A(i, i) += here;
    }
    if (k < n) {
      A = times(M, A);
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
