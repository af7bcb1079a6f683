// Approximate inverses of small matrices, for preconditioning and Newton steps: proposals, never proofs.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "core/ball.hpp"

namespace stickslip::numeric::zeros {

// The size of a pivot, roughly.
[[nodiscard]] inline double magnitude(double x) {
  return std::abs(x);
}
template <class S>
[[nodiscard]] double magnitude(const S& x) {
  return std::abs(x.approximate());
}

// The number without its error: what a proposal is computed with.
[[nodiscard]] inline double centre(double x) {
  return x;
}
[[nodiscard]] inline Ball centre(const Ball& x) {
  return x.midpoint();
}
template <class S>
[[nodiscard]] S centre(const S& x) {
  return S(x.approximate());
}

// a b, each entry a sum over balls: Eigen's own product of large matrices wants scalars that can be compared.
template <class A, class B>
[[nodiscard]] auto product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return a.derived().lazyProduct(b.derived());
}

// Gauss-Jordan elimination with row pivoting on the midpoints of a. Over balls the entries of the result are
// exact numbers near the inverse, with no guarantee. Nothing when a pivot vanishes or is not finite.
template <class S, int N>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, N>> approximate_inverse(Eigen::Matrix<S, N, N> a) {
  const auto n = static_cast<int>(a.rows());
  Eigen::Matrix<S, N, N> inverse = Eigen::Matrix<S, N, N>::Identity(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      a(i, j) = centre(a(i, j));
    }
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i) {
      pivot = magnitude(a(i, k)) > magnitude(a(pivot, k)) ? i : pivot;
    }
    const double size = magnitude(a(pivot, k));
    if (!(size > 0) || !std::isfinite(size)) {
      return std::nullopt;
    }
    a.row(k).swap(a.row(pivot));
    inverse.row(k).swap(inverse.row(pivot));
    const S reciprocal = centre(S(S(1) / a(k, k)));
    for (int j = 0; j < n; ++j) {
      a(k, j) = centre(S(a(k, j) * reciprocal));
      inverse(k, j) = centre(S(inverse(k, j) * reciprocal));
    }
    for (int i = 0; i < n; ++i) {
      if (i == k) {
        continue;
      }
      const S factor = a(i, k);
      for (int j = 0; j < n; ++j) {
        a(i, j) = centre(S(a(i, j) - factor * a(k, j)));
        inverse(i, j) = centre(S(inverse(i, j) - factor * inverse(k, j)));
      }
    }
  }
  return inverse;
}

// Whether a is proved to be invertible, all members of its entries: |I - Y a| < 1 in the norm of row sums for
// the approximate inverse Y.
template <int N>
[[nodiscard]] bool is_invertible(const Eigen::Matrix<Ball, N, N>& a) {
  const std::optional<Eigen::Matrix<Ball, N, N>> Y = approximate_inverse<Ball, N>(a);
  if (!Y) {
    return false;
  }
  const Eigen::Matrix<Ball, N, N> rest = Eigen::Matrix<Ball, N, N>::Identity() - product(*Y, a);
  for (int i = 0; i < N; ++i) {
    Ball sum(-1);
    for (int j = 0; j < N; ++j) {
      sum += abs(rest(i, j));
    }
    if (!sum.is_negative()) {
      return false;
    }
  }
  return true;
}

}  // namespace stickslip::numeric::zeros
