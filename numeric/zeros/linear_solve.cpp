#include "numeric/zeros/linear_solve.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <utility>

namespace stickslip::numeric::zeros {

using Balls = BallMatrix<Eigen::Dynamic>;

namespace {

// The number without its error: what a proposal is computed with.
double centre(double x) {
  return x;
}
Ball centre(const Ball& x) {
  return x.midpoint();
}

template <class Matrix>
std::optional<Matrix> combinations(Matrix a) {
  using S = typename Matrix::Scalar;
  const Eigen::Index rows = a.rows(), columns = a.cols();
  Matrix combined = Matrix::Identity(rows, rows);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    a.data()[i] = centre(a.data()[i]);
  }
  for (Eigen::Index k = 0; k < columns; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < rows; ++i) {
      pivot = magnitude(a(i, k)) > magnitude(a(pivot, k)) ? i : pivot;
    }
    const double size = magnitude(a(pivot, k));
    if (!(size > 0) || !std::isfinite(size)) {
      return std::nullopt;
    }
    const auto each = [&](const auto& update) {
      for (Eigen::Index j = 0; j < columns; ++j) {
        update(a, j);
      }
      for (Eigen::Index j = 0; j < rows; ++j) {
        update(combined, j);
      }
    };
    each([&](Matrix& m, Eigen::Index j) { std::swap(m(k, j), m(pivot, j)); });
    const S reciprocal = centre(S(S(1) / a(k, k)));
    each([&](Matrix& m, Eigen::Index j) { m(k, j) = centre(S(m(k, j) * reciprocal)); });
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (i != k) {
        const S factor = a(i, k);
        each([&](Matrix& m, Eigen::Index j) { m(i, j) = centre(S(m(i, j) - factor * m(k, j))); });
      }
    }
  }
  return combined;
}

}  // namespace

std::optional<Eigen::MatrixXd> row_combinations(const Eigen::MatrixXd& a) {
  return combinations(a);
}
std::optional<Balls> row_combinations(const Balls& a) {
  return combinations(a);
}

Ball norm(const Balls& a) {
  Ball most(0);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    Ball sum(0);
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      sum += abs(a(i, j));
    }
    arb_max(most.raw(), most.raw(), sum.raw(), WorkingPrecision::bits());
  }
  return most.upper();
}

bool is_invertible(const Balls& a) {
  const std::optional<Balls> Y = a.rows() == a.cols() ? row_combinations(a) : std::nullopt;
  if (!Y) {
    return false;
  }
  const Balls rest = Balls::Identity(a.rows(), a.cols()) - product(*Y, a);
  return (norm(rest) - Ball(1)).is_negative();
}

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
