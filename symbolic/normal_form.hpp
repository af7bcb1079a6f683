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

#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/scalar.hpp"

namespace stickslip::symbolic {

// The pair that stands for one phase: c = cos(angle), s = sin(angle).
struct Circle {
  GiNaC::ex angle;
  GiNaC::ex c;
  GiNaC::ex s;
};

// The generators that a set of expressions needs. Throws OutsideField if one of them is not of the form
// above.
class TrigField {
 public:
  explicit TrigField(const std::vector<GiNaC::ex>& expressions);

  // The expression as a rational function of symbols and generators, π being one of them; not normalised.
  [[nodiscard]] GiNaC::ex to_generators(const GiNaC::ex& expression) const;

  // A polynomial in the generators with every s² replaced by 1 - c², expanded: zero exactly if it vanishes on
  // all circles.
  [[nodiscard]] GiNaC::ex reduce(const GiNaC::ex& polynomial) const;

  // Whether the expression is identically zero. Throws OutsideField if it divides by zero.
  [[nodiscard]] bool is_zero(const GiNaC::ex& expression) const;

  // Back from generators to cos, sin and π.
  [[nodiscard]] GiNaC::ex from_generators(const GiNaC::ex& expression) const;

  [[nodiscard]] const std::vector<Circle>& circles() const { return circles_; }

 private:
  std::vector<Circle> circles_;
};

// An expression is not in the field: what stands in the way.
struct OutsideField : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace stickslip::symbolic
