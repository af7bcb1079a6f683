#include "numeric/zeros/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace stickslip::numeric::zeros {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A) {
  return A.eigenvalues();
}

double spectral_radius(const Eigen::MatrixXd& A) {
  return eigenvalues(A).cwiseAbs().maxCoeff();
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& A) {
  return A.inverse();
}

std::optional<Eigen::MatrixXd> cholesky(const Eigen::MatrixXd& A) {
  const Eigen::LLT<Eigen::MatrixXd> llt(A);
  return llt.info() == Eigen::Success ? std::optional<Eigen::MatrixXd>(llt.matrixL()) : std::nullopt;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd kernel(const Eigen::MatrixXd& A) {
  return A.fullPivLu().kernel();
}

Eigen::MatrixXd reflections(const Eigen::MatrixXd& A) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).matrixQR();
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& A) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ();
}

}  // namespace stickslip::numeric::zeros
