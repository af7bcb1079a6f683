// Scalar expressions and matrices of them as text: LaTeX for papers, one plain line for terminals. The layout
// is that of formula.hpp: the same characters on every run, whatever the order in which an expression was
// built.
#pragma once

#include <string>
#include <vector>

#include "symbolic/algebra/symbols.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::symbolic::typeset {

// LaTeX for math mode: "\frac{\lambda_2\cos\omega_1 t-\lambda_1\cos\omega_2 t}{\lambda_2-\lambda_1}". Never a
// fraction within a fraction; within one, arguments are written with a slash: \sin(\omega\tau/2). Symbols are
// written by latex_name(). Two symbols of the same name are taken as one. Throws InternalError for what is
// not a scalar or not exact (arrange()).
[[nodiscard]] std::string latex(const GiNaC::ex& expression);

// The same on one line of plain characters, names as they are: "omega1^2 - omega2^2".
[[nodiscard]] std::string text(const GiNaC::ex& expression);

// A pmatrix (amsmath, with \dfrac), row by row; a denominator common to all nonzero entries stands in front,
// together with what their numerators share.
[[nodiscard]] std::string latex(const std::vector<GiNaC::ex>& entries, std::size_t columns);

template <class Derived>
[[nodiscard]] std::string latex(const Eigen::MatrixBase<Derived>& matrix) {
  const auto& evaluated = matrix.eval();
  std::vector<GiNaC::ex> entries;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      entries.push_back(evaluated(i, j));
    }
  }
  return latex(entries, static_cast<std::size_t>(matrix.cols()));
}

}  // namespace stickslip::symbolic::typeset
