// Approximate inverses of small matrices, for preconditioning and Newton steps: proposals, never proofs.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <type_traits>

#include "core/ball.hpp"

namespace stickslip::numeric::zeros {

// The size of a number, roughly.
[[nodiscard]] inline double magnitude(double x) {
  return std::abs(x);
}
template <class S>
[[nodiscard]] double magnitude(const S& x) {
  return std::abs(x.approximate());
}

// a b, each entry a sum over balls, by Arb's own where they are Arb's: Eigen's product of large matrices
// wants scalars that can be compared.
template <class A, class B>
[[nodiscard]] auto product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  if constexpr (std::is_same_v<typename A::Scalar, Ball> && std::is_same_v<typename B::Scalar, Ball>) {
    static_assert(sizeof(Ball) == sizeof(arb_struct));
    const auto& x = a.derived().eval();
    const auto& y = b.derived().eval();
    Eigen::Matrix<Ball, A::RowsAtCompileTime, B::ColsAtCompileTime> result(a.rows(), b.cols());
    for (Eigen::Index i = 0; a.cols() > 0 && i < a.rows(); ++i) {
      for (Eigen::Index k = 0; k < b.cols(); ++k) {
        arb_dot(result(i, k).raw(), nullptr, 0, x(i, 0).raw(), x.IsRowMajor ? 1 : x.rows(), y(0, k).raw(),
                y.IsRowMajor ? y.cols() : 1, a.cols(), WorkingPrecision::bits());
      }
    }
    return result;
  } else {
    return a.derived().lazyProduct(b.derived());
  }
}

template <int N>
using BallMatrix = Eigen::Matrix<Ball, N, N>;

// E for which E a is nearly the unit matrix above zeros, for at least as many rows as columns: Gauss-Jordan
// elimination with row pivoting on the midpoints of a. Over balls the entries of the result are exact
// numbers, with no guarantee. Nothing when a pivot vanishes or is not finite.
[[nodiscard]] std::optional<Eigen::MatrixXd> row_combinations(const Eigen::MatrixXd& a);
[[nodiscard]] std::optional<BallMatrix<Eigen::Dynamic>> row_combinations(const BallMatrix<Eigen::Dynamic>& a);

// The midpoints of an expression over balls of any kind.
template <class A>
[[nodiscard]] Eigen::MatrixXd in_double(const Eigen::MatrixBase<A>& a) {
  Eigen::MatrixXd result(a.rows(), a.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      result(i, j) = a(i, j).approximate();
    }
  }
  return result;
}

// The same as exact balls.
template <class A>
[[nodiscard]] typename A::PlainObject midpoints(const Eigen::MatrixBase<A>& a) {
  return a.unaryExpr([](const Ball& x) { return x.midpoint(); });
}

// Nearly the inverse, likewise; balls in hardware have one in double.
template <class S, int N>
[[nodiscard]] std::optional<Eigen::Matrix<S, N, N>> approximate_inverse(const Eigen::Matrix<S, N, N>& a) {
  if constexpr (std::is_same_v<S, Ball> || std::is_same_v<S, double>) {
    if (const auto found = row_combinations(Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>(a))) {
      return Eigen::Matrix<S, N, N>(*found);
    }
  } else if (const auto found = row_combinations(in_double(a))) {
    return Eigen::Matrix<S, N, N>(found->template cast<S>());
  }
  return std::nullopt;
}

// The largest sum of sizes in a row, from above.
[[nodiscard]] Ball norm(const BallMatrix<Eigen::Dynamic>& a);

// Whether a is proved to be invertible, all members of its entries: |I - Y a| < 1 in the norm of row sums for
// the approximate inverse Y. A matrix that is not square is not.
[[nodiscard]] bool is_invertible(const BallMatrix<Eigen::Dynamic>& a);

// Decompositions of matrices in floating point: Eigen's, of which each takes seconds to compile, so once for
// all who use them. A matrix that is not finite has results that are not.

// Of a square matrix, in no order.
[[nodiscard]] Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A);
[[nodiscard]] double spectral_radius(const Eigen::MatrixXd& A);

// Of a square matrix.
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);

// L, lower triangular, with L Lᵀ = A; nothing unless A is positive definite.
[[nodiscard]] std::optional<Eigen::MatrixXd> cholesky(const Eigen::MatrixXd& A);

// The shortest of those x for which A x is nearest to b.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

// A basis, as columns, of those x for which A x = 0, as far as rounding tells.
[[nodiscard]] Eigen::MatrixXd kernel(const Eigen::MatrixXd& A);

// Householder's QR of a square matrix: the vectors v of the reflections I - 2 v vᵀ/(v v), each from below the
// diagonal on, where its first entry is 1; and the product of these, Q.
[[nodiscard]] Eigen::MatrixXd reflections(const Eigen::MatrixXd& A);
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& A);

}  // namespace stickslip::numeric::zeros
