// Polynomials in letters as FLINT's, and back.
#pragma once

#include <vector>

#include "core/polynomial.hpp"
#include "proofs/tactics/letters.hpp"

namespace stickslip::proofs::tactics {

// Its terms, the leading one first; and the polynomial of these, whose degrees are of the ring's generators.
[[nodiscard]] std::vector<Letters::Monomial> monomials(const Polynomial& polynomial);
[[nodiscard]] Polynomial polynomial(const PolynomialRing& ring,
                                    const std::vector<Letters::Monomial>& monomials);

// The same in the letters' symbols, one for each generator.
[[nodiscard]] GiNaC::ex expression(const std::vector<Letters::Monomial>& monomials, const Letters& letters);

// The irreducible factors with their exponents, without the constant one, each with whole coefficients that
// have no common divisor. Throws std::overflow_error where FLINT gives up.
[[nodiscard]] std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& polynomial);

}  // namespace stickslip::proofs::tactics
