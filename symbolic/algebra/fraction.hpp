// Rational expressions as one fraction of polynomials.
#pragma once

#include <vector>

#include "symbolic/algebra/polynomial_ring.hpp"

namespace stickslip::symbolic::algebra {

struct Fraction {
  Polynomial numerator, denominator;
};

// A rational expression in symbols of the ring as a fraction in lowest terms, modulo the relations: a Gröbner
// basis of a prime ideal. The numerator is zero exactly if the expression is, modulo them. Throws
// OutsideField if it divides by something that is zero modulo them, and InternalError if a symbol is not the
// ring's.
[[nodiscard]] Fraction over_one_denominator(const GiNaC::ex& expression, const PolynomialRing& ring,
                                            const std::vector<Polynomial>& relations);

}  // namespace stickslip::symbolic::algebra
