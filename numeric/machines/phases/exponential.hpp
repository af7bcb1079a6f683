// Exponentials of matrices of balls, and of matrices that depend on data.
#pragma once

#include "model/friction_oscillator.hpp"
#include "numeric/machines/phases/in_data.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

using Matrix = model::MatrixX<Ball>;
using Vector = model::VectorX<Ball>;

// exp(A), by Arb.
[[nodiscard]] Matrix exponential(const Matrix& A);

// exp(A), of all members of a matrix in data. The rows and columns of A are balanced by the units, powers of
// two. Not finite where |A| is not below 2^60 in them.
[[nodiscard]] InData<Matrix> exponential(const InData<Matrix>& A, const Vector& units);

// S, powers of two that bring rows and columns of S B S⁻¹ to sums of one size: any S is right where one is
// asked for, this one makes short work.
[[nodiscard]] Vector balance(const Matrix& B);

// An upper bound of the norm of row sums of U⁻¹ A U, U the diagonal matrix of the units.
[[nodiscard]] Ball size_in(const Vector& units, const Matrix& A);

// a b, for an a with many zeros.
template <class M>
[[nodiscard]] M sparse_product(const Matrix& a, const M& b) {
  M product = M::Constant(a.rows(), b.cols(), Ball(0));
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index l = 0; l < a.cols(); ++l) {
      for (Eigen::Index k = 0; !is_zero(a(i, l)) && k < b.cols(); ++k) {
        add_product(product(i, k), a(i, l), b(l, k));
      }
    }
  }
  return product;
}

}  // namespace stickslip::numeric::machines
