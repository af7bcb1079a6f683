// Polynomials with rational coefficients in symbols: the arithmetic of the normal form.
#pragma once

#include <vector>

#include "core/polynomial.hpp"
#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

// Q[x_1, …, x_n] in the given symbols, which must differ; the first symbol leads.
class PolynomialRing : public stickslip::PolynomialRing {
 public:
  explicit PolynomialRing(const std::vector<GiNaC::ex>& symbols)
      : stickslip::PolynomialRing(symbols.size()), symbols_(symbols) {}

  // Throws InternalError if the symbol is not one of the ring's.
  [[nodiscard]] Polynomial generator(const GiNaC::ex& symbol) const;
  [[nodiscard]] Polynomial constant(const GiNaC::numeric& rational) const;

  // The polynomial as a sum of monomials in the ring's symbols.
  [[nodiscard]] GiNaC::ex expression(const Polynomial& polynomial) const;

 private:
  std::vector<GiNaC::ex> symbols_;
};

[[nodiscard]] Polynomial pow(const Polynomial& base, unsigned long exponent);
[[nodiscard]] bool divides(const Polynomial& divisor, const Polynomial& multiple);

// An irreducible polynomial with integer coefficients, and how often it stands in a product.
struct Factor {
  Polynomial base;
  unsigned long exponent = 1;
};

// A polynomial other than 0 as constant * product of powers.
struct Factors {
  Rational constant;
  std::vector<Factor> factors;
};
[[nodiscard]] Factors factored(const Polynomial& polynomial);

}  // namespace stickslip::symbolic::algebra
