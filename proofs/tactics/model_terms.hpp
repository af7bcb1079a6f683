// Kernel terms as a scalar of the model: its formulas become the bodies of definitions.
#pragma once

#include "model/scalar_traits.hpp"
#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::tactics {

// A number as the model's templates want one.
struct Symbolic {
  kernel::Term term = 0;

  Symbolic() = default;
  Symbolic(int value) : term(value) {}                            // NOLINT: scalars convert from int
  Symbolic(kernel::Term value) : term(std::move(value)) {}        // NOLINT
  Symbolic(const kernel::Variable& variable) : term(variable) {}  // NOLINT

  // Without the zeros and ones that matrices are full of.
  friend Symbolic operator+(const Symbolic& a, const Symbolic& b) {
    return a.term == kernel::Term(0) ? b : b.term == kernel::Term(0) ? a : Symbolic(a.term + b.term);
  }
  friend Symbolic operator*(const Symbolic& a, const Symbolic& b) {
    if (a.term == kernel::Term(0) || b.term == kernel::Term(0)) {
      return 0;
    }
    return a.term == kernel::Term(1) ? b : b.term == kernel::Term(1) ? a : Symbolic(a.term * b.term);
  }
  friend Symbolic operator-(const Symbolic& a) { return a.term == kernel::Term(0) ? a : Symbolic(-a.term); }
  friend Symbolic operator-(const Symbolic& a, const Symbolic& b) { return a + -b; }
  friend Symbolic operator/(const Symbolic& a, const Symbolic& b) {
    return b.term == kernel::Term(1) ? a : Symbolic(a.term / b.term);
  }
  Symbolic& operator+=(const Symbolic& b) { return *this = *this + b; }
  Symbolic& operator-=(const Symbolic& b) { return *this = *this - b; }
  Symbolic& operator*=(const Symbolic& b) { return *this = *this * b; }
  Symbolic& operator/=(const Symbolic& b) { return *this = *this / b; }
  friend Symbolic cos(const Symbolic& a) { return kernel::cos(a.term); }
  friend Symbolic sin(const Symbolic& a) { return kernel::sin(a.term); }
  friend Symbolic exp(const Symbolic& a) { return kernel::exp(a.term); }
};

// A matrix of the model as a term.
template <class Derived>
[[nodiscard]] kernel::Term as_term(const Eigen::MatrixBase<Derived>& matrix) {
  const auto& evaluated = matrix.eval();
  std::vector<kernel::Term> entries;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      entries.push_back(evaluated(i, j).term);
    }
  }
  return kernel::matrix(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), entries);
}

}  // namespace stickslip::proofs::tactics

namespace Eigen {

template <>
struct NumTraits<stickslip::proofs::tactics::Symbolic>
    : stickslip::model::ScalarTraits<stickslip::proofs::tactics::Symbolic, 2, 100, 100> {};

}  // namespace Eigen
