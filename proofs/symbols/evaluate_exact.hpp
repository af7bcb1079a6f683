// GiNaC's expressions at an exact point.
#pragma once

#include "numeric/scalars/exact.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::symbols {

// The values of expressions, as they stand, at one point. Throws ZeroDivision, and NoExactValue for what is
// not rational in symbols and trigonometric functions of phases.
class ExactValues {
 public:
  explicit ExactValues(Lookup<numeric::scalars::Exact> scalar) : scalar_(std::move(scalar)) {}
  [[nodiscard]] Rational operator()(const GiNaC::ex& expression);

 private:
  // As a number that may be an angle.
  [[nodiscard]] numeric::scalars::Exact angle(const GiNaC::ex& expression);
  [[nodiscard]] Rational function(const GiNaC::ex& expression);

  Lookup<numeric::scalars::Exact> scalar_;
  std::map<GiNaC::ex, std::pair<Rational, Rational>, GiNaC::ex_is_less> sin_cos_;  // of angles
};

}  // namespace stickslip::proofs::symbols
