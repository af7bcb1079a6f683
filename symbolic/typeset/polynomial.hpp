// Expressions as rational functions of variables that stand for symbols, π and functions, and polynomials in
// these with a term order that does not depend on the run, for the layout of formulas (formula.hpp).
#pragma once

#include <utility>
#include <vector>

#include "core/monomials.hpp"
#include "symbolic/typeset/formula.hpp"

namespace stickslip::symbolic::typeset {

// The atoms that a polynomial is written in, sorted, and the variables that stand for them.
struct Alphabet {
  std::vector<Atom> atoms;
  std::vector<GiNaC::ex> variables;
};

struct Rationalized {
  GiNaC::ex rational;
  Alphabet alphabet;
};

// Arguments of cos, sin, tan are expanded and signed so that their first term is positive. Throws as
// arrange() does.
[[nodiscard]] Rationalized rationalize(const GiNaC::ex& expression);

using Degrees = std::vector<int>;  // one exponent per atom

// Nonzero terms, leading one first: higher power of π, then higher total degree, then the earlier atom.
using Polynomial = std::vector<Monomial>;

// Reads a polynomial in the variables.
[[nodiscard]] Polynomial to_polynomial(const GiNaC::ex& expression, const Alphabet& alphabet);

// A fraction of a number and powers of atoms, of any sign.
[[nodiscard]] Fraction to_fraction(const Monomial& monomial, const Alphabet& alphabet);

// unit · monomial · Π sums: each sum primitive over the integers with a positive leading term, in no
// particular order, irreducible except for conjugates: f(x)·f(-x) stays together when both have
// the same exponent.
struct Factors {
  Rational unit;
  Degrees monomial;
  std::vector<std::pair<Polynomial, int>> sums;
};

// Assumes a nonzero polynomial.
[[nodiscard]] Factors factorise(const Polynomial& polynomial, const Alphabet& alphabet);

// The parts of a polynomial by what they contain of cos, sin, tan: degrees in these alone, and coefficient in
// the rest; leading one first.
[[nodiscard]] std::vector<std::pair<Degrees, Polynomial>> collect_trigonometric(const Polynomial& polynomial,
                                                                                const Alphabet& alphabet);

}  // namespace stickslip::symbolic::typeset
