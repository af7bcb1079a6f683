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

// E for which E a is nearly the unit matrix above zeros, for at least as many rows as columns: Gauss-Jordan
// elimination with row pivoting on the midpoints of a. Over balls the entries of the result are exact
// numbers, with no guarantee. Nothing when a pivot vanishes or is not finite.
template <class S, int R, int U>
[[nodiscard]] std::optional<Eigen::Matrix<S, R, R>> row_combinations(Eigen::Matrix<S, R, U> a) {
  const auto rows = static_cast<int>(a.rows()), columns = static_cast<int>(a.cols());
  Eigen::Matrix<S, R, R> combined = Eigen::Matrix<S, R, R>::Identity(rows, rows);
  a = a.unaryExpr([](const S& x) { return centre(x); });
  for (int k = 0; k < columns; ++k) {
    int pivot = k;
    for (int i = k + 1; i < rows; ++i) {
      pivot = magnitude(a(i, k)) > magnitude(a(pivot, k)) ? i : pivot;
    }
    const double size = magnitude(a(pivot, k));
    if (!(size > 0) || !std::isfinite(size)) {
      return std::nullopt;
    }
    a.row(k).swap(a.row(pivot));
    combined.row(k).swap(combined.row(pivot));
    const auto each = [&](const auto& update) {
      for (int j = 0; j < columns; ++j) {
        update(a, j);
      }
      for (int j = 0; j < rows; ++j) {
        update(combined, j);
      }
    };
    const S reciprocal = centre(S(S(1) / a(k, k)));
    each([&](auto& m, int j) { m(k, j) = centre(S(m(k, j) * reciprocal)); });
    for (int i = 0; i < rows; ++i) {
      if (i != k) {
        const S factor = a(i, k);
        each([&](auto& m, int j) { m(i, j) = centre(S(m(i, j) - factor * m(k, j))); });
      }
    }
  }
  return combined;
}

// Nearly the inverse, likewise.
template <class S, int N>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, N>> approximate_inverse(const Eigen::Matrix<S, N, N>& a) {
  return row_combinations<S, N, N>(a);
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
