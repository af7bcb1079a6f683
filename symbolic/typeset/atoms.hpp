// From an expression to a rational function of variables that stand for its symbols, π and its functions.
#pragma once

#include "symbolic/typeset/polynomial.hpp"

namespace stickslip::symbolic::typeset {

struct Rationalized {
  GiNaC::ex rational;
  Alphabet alphabet;
};

// Arguments of cos, sin, tan are expanded and signed so that their first term is positive. Throws as
// arrange() does.
[[nodiscard]] Rationalized rationalize(const GiNaC::ex& expression);

}  // namespace stickslip::symbolic::typeset
