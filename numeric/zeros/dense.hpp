// Decompositions of matrices in floating point: Eigen's, of which each takes seconds to compile, so once for
// all who use them. A matrix that is not finite has results that are not.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace stickslip::numeric::zeros {

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
