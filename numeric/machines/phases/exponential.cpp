#include "numeric/machines/phases/exponential.hpp"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

#include <algorithm>
#include <cmath>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

class ArbMatrix {
 public:
  explicit ArbMatrix(const Matrix& A) {
    arb_mat_init(value_, A.rows(), A.cols());
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      for (Eigen::Index k = 0; k < A.cols(); ++k) {
        arb_set(arb_mat_entry(value_, i, k), A(i, k).raw());
      }
    }
  }
  ArbMatrix(const ArbMatrix&) = delete;
  ArbMatrix& operator=(const ArbMatrix&) = delete;
  ~ArbMatrix() { arb_mat_clear(value_); }

  [[nodiscard]] arb_mat_struct * raw() { return value_; }

 private:
  arb_mat_t value_;
};

}  // namespace

Matrix exponential(const Matrix& A) {
  ArbMatrix a(A);
  arb_mat_exp(a.raw(), a.raw(), WorkingPrecision::bits());
  Matrix result(A.rows(), A.cols());
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index k = 0; k < A.cols(); ++k) {
      arb_set(result(i, k).raw(), arb_mat_entry(a.raw(), i, k));
    }
  }
  return result;
}

Vector balance(const Matrix& B) {
  const Eigen::Index n = B.rows();
  const Eigen::MatrixXd A = zeros::in_double(B).cwiseAbs();
  Eigen::VectorXd s = Eigen::VectorXd::Ones(n);
  for (int round = 0; round < 8; ++round) {
    for (Eigen::Index i = 0; i < n; ++i) {
      double row = 0, column = 0;
      for (Eigen::Index k = 0; k < n; ++k) {
        if (k != i) {
          row += A(i, k) * s(i) / s(k);
          column += A(k, i) * s(k) / s(i);
        }
      }
      const double factor =
          row > 0 && column > 0 ? std::sqrt(column / row) : (column > 0 ? column : (row > 0 ? 1 / row : 1));
      if (std::isfinite(factor) && factor > 0) {
        s(i) *= std::exp2(std::clamp(std::round(std::log2(factor)), -60.0, 60.0));
      }
    }
  }
  return s.unaryExpr([](double x) { return Ball(x); });
}

namespace {

// Which entries a function of B may have: those that a product of such matrices may.
Eigen::MatrixXi pattern_of(const Matrix& B) {
  const Eigen::Index n = B.rows();
  Eigen::MatrixXi may = Eigen::MatrixXi::Identity(n, n);
  for (Eigen::Index i = 0; i < may.size(); ++i) {
    may.data()[i] += is_zero(B.data()[i]) ? 0 : 1;
  }
  for (Eigen::Index through = 0; through < n; ++through) {
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index i = 0; may(through, k) != 0 && i < n; ++i) {
        may(i, k) = may(i, k) != 0 || may(i, through) != 0 ? 1 : 0;
      }
    }
  }
  return may;
}

}  // namespace

Ball size_in(const Vector& units, const Matrix& A) {
  return zeros::norm(Matrix(units.cwiseInverse().asDiagonal() * A * units.asDiagonal())).upper();
}

// The Taylor polynomial of A/2^k, squared k times.
InData<Matrix> exponential(const InData<Matrix>& A, const Vector& units) {
  constexpr int most_halvings = 60;
  const Matrix all = A.all();
  const Eigen::Index n = all.rows();
  InData<Matrix> E(Matrix::Identity(n, n));
  const double size = size_in(units, all).approximate();
  if (!(size < std::exp2(most_halvings))) {
    return InData<Matrix>(Matrix::Constant(n, n, scalars::anything()));
  }
  const int halvings = size > 0.5 ? static_cast<int>(std::ceil(std::log2(size))) + 1 : 0;
  const InData<Matrix> part = A * Ball(std::exp2(-halvings));
  const Ball q = size_in(units, part.all());
  InData<Matrix> term = E;
  Ball power = q;  // q^m/m!, q < 1
  const double enough = std::exp2(-static_cast<double>(WorkingPrecision::bits()));
  for (long m = 1; m == 1 || power.approximate() > enough; ++m) {
    term = product(part, term, sparse_product<Matrix>) * (Ball(1) / Ball(m));
    E += term;
    power = Ball(power * q / Ball(m + 1)).upper();
  }
  // What is left out is at most twice its first term.
  const Eigen::MatrixXi pattern = pattern_of(all);
  Matrix rest = Matrix::Constant(n, n, Ball(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      rest(i, k) = pattern(i, k) != 0 ? scalars::within(Ball(2) * power * units(i) / units(k)) : Ball(0);
    }
  }
  add(E.rest, rest);
  for (int k = 0; k < halvings; ++k) {
    E = E * E;
  }
  return E;
}

}  // namespace stickslip::numeric::machines
