// Trigonometric-rational expressions as elements of a field in which "is it zero" is decided by a normal
// form.
//
// The field: rational functions over Q in the symbols, π, and one pair (c, s) with c² + s² = 1 for every
// independent phase. A phase is a Laurent monomial in the symbols and π (omega1*tau, pi*omega1/omega, phi);
// cos and sin of rational combinations of phases enter through the addition theorems, tan as sin/cos.
// Distinct nonconstant monomials are linearly independent over Q modulo constants, so their exponentials are
// algebraically independent over the rational functions (Ax); and π is transcendental. Hence an expression is
// identically zero exactly if its normal form is.
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "symbolic/algebra/fraction.hpp"

namespace stickslip::symbolic::algebra {

// The pair that stands for one phase: c = cos(angle), s = sin(angle).
struct Circle {
  GiNaC::ex angle;
  GiNaC::ex c;
  GiNaC::ex s;
};

// The field that a set of expressions needs. Throws OutsideField if one of them is not of the form above.
class TrigField {
 public:
  explicit TrigField(const std::vector<GiNaC::ex>& expressions);

  // Whether the expression is identically zero. Here and below: it has no phases and symbols but those of the
  // expressions that the field was made for. Throws OutsideField if it divides by zero.
  [[nodiscard]] bool is_zero(const GiNaC::ex& expression) const;

  // The expression as a fraction of polynomials in the symbols, π and the generators, in lowest terms and
  // with every s² replaced by 1 - c². Throws OutsideField if it divides by zero.
  [[nodiscard]] Fraction fraction(const GiNaC::ex& expression) const;

  // A polynomial with every s² replaced by 1 - c²: zero exactly if it vanishes on all circles.
  [[nodiscard]] Polynomial reduced(const Polynomial& polynomial) const;

  // Back from generators to cos, sin and π.
  [[nodiscard]] GiNaC::ex expression(const Polynomial& polynomial) const;

 private:
  std::vector<Circle> circles_;
  std::unique_ptr<PolynomialRing> ring_;
  std::vector<Polynomial> relations_;  // c² + s² - 1 of every circle
};

// An expression is not in the field: what stands in the way.
struct OutsideField : std::runtime_error {
  using std::runtime_error::runtime_error;
};
extern const char * const divides_by_zero;

}  // namespace stickslip::symbolic::algebra
