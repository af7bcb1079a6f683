// Polynomials term by term, and as products.
#pragma once

#include <utility>
#include <vector>

#include "core/polynomial.hpp"

namespace stickslip {

struct Monomial {
  std::vector<int> degrees;  // of the ring's generators
  Rational coefficient;

  friend bool operator==(const Monomial&, const Monomial&) = default;
};
// The terms of a polynomial, the leading one first; and the polynomial of such terms.
[[nodiscard]] std::vector<Monomial> monomials(const Polynomial& polynomial);
[[nodiscard]] Polynomial polynomial(const PolynomialRing& ring, const std::vector<Monomial>& monomials);

// The content, by which the polynomial, which is not zero, is divided: its coefficients are whole then,
// without a common divisor.
Rational take_content(Polynomial& polynomial);

// The irreducible factors with their exponents, without the constant one; the whole where FLINT gives up.
[[nodiscard]] std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& polynomial);

}  // namespace stickslip
