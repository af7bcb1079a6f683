// Polynomials with a term order that does not depend on the run, for the layout of formulas (formula.hpp).
#pragma once

#include <utility>
#include <vector>

#include "symbolic/typeset/formula.hpp"

namespace stickslip::symbolic::typeset {

// The atoms that a polynomial is written in, sorted, and the variables that stand for them.
struct Alphabet {
  std::vector<Atom> atoms;
  std::vector<GiNaC::ex> variables;
};

using Degrees = std::vector<int>;  // one exponent per atom

struct Term {
  Degrees degrees;
  GiNaC::numeric coefficient;
};

// Nonzero terms, leading one first: higher power of π, then higher total degree, then the earlier atom.
using Polynomial = std::vector<Term>;

// Whether a comes before b in a polynomial.
[[nodiscard]] bool leads(const Degrees& a, const Degrees& b, const Alphabet& alphabet);

// Reads a polynomial in the variables, and gives it back.
[[nodiscard]] Polynomial to_polynomial(const GiNaC::ex& expression, const Alphabet& alphabet);
[[nodiscard]] GiNaC::ex to_expression(const Polynomial& polynomial, const Alphabet& alphabet);

// unit · monomial · Π sums: each sum primitive over the integers with a positive leading term, in no
// particular order, irreducible except for conjugates: f(x)·f(-x) stays together when both have
// the same exponent.
struct Factors {
  GiNaC::numeric unit;
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
