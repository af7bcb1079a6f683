// Methods of proof for statements that follow from others: equations as combinations of equations,
// inequalities as positive combinations of inequalities, chains of claims.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/methods.hpp"

namespace stickslip::proofs::methods {

// left * (difference of the sides of a premise's statement) * right; `statement` counts its statements from
// 0.
struct Multiple {
  Premise premise;
  std::size_t statement = 0;
  symbols::Term left = 1;
  symbols::Term right = 1;
};

// The difference of the sides of each printed equation is the given sum of multiples of premises,
// identically. What the multiples divide by are hypotheses. One list per printed equation.
[[nodiscard]] Proof by_combination(std::vector<std::vector<Multiple>> combinations);

// A product that is positive: of a coefficient, and of the differences (larger minus smaller side) of
// premises that are inequalities.
struct Positive {
  symbols::Term coefficient = 1;
  std::vector<Multiple> factors = {};  // `left` and `right` are not used
};

// Why an inequality follows: the sum of `divisors`, times the difference of its sides, is the sum of
// `positive` and of multiples of equations. Every sum is of at least one term; without divisors they are 1.
struct Certificate {
  std::vector<Positive> positive;
  std::vector<Multiple> equations = {};
  std::vector<Positive> divisors = {};
};

// Each printed inequality follows by its certificate, checked by normal form. Coefficients must be certain to
// be positive on the domain, up to squares, whose zeros become hypotheses. An absolute value that is one side
// of a strict inequality is done away with by squares; the other side must then be positive, as the premise
// `positive_side` says.
[[nodiscard]] Proof by_positive_combination(std::vector<Certificate> certificates,
                                            std::optional<Premise> positive_side = {});

// The printed equations hold identically once the premises, each of the form "symbol = value", are put in.
[[nodiscard]] Proof by_putting_in(std::vector<Premise> premises);

// The printed equation says "inverse(A) = B", the premise A B = I.
[[nodiscard]] Proof by_inverse(Premise product);

// The printed equation "variable = value" follows from `zero`, cos(angle) = 0, as lower*pi < angle <
// upper*pi; the angle is a multiple of the variable.
struct ZeroOfCosine {
  symbols::Term angle;
  Premise zero;
  Rational lower, upper;
};
[[nodiscard]] Proof by_zero_of_cosine(const ZeroOfCosine& step);

// The printed "A != 0" follows from the assumption "B != 0", as B^2 = multiplier * A by normal form.
[[nodiscard]] Proof by_nonzero_multiple(const std::string& assumption, const symbols::Term& multiplier);

// The printed left sides are names to which the table of symbols gives this meaning: what is printed is a
// theorem. A definition of names that have none is no claim to be proved: it has no proof, and is taken as
// given.
[[nodiscard]] Proof by_definition();

// A theorem of the kernel that rests on nothing but the ranges of its variables, and says what the words do:
// that is for the reader to compare.
[[nodiscard]] Proof by_theorem(const std::string& route, kernel::Theorem (*make)());

// At the point, where the symbols of `values` take the values given (in terms of one another and of the
// point), every statement of `true_there` holds and none of `false_there` does: the theorem says that there
// are such values (refutation.hpp). A refutation of what says that the former imply one of the latter.
struct Counterexample {
  std::vector<Coordinate> point;
  std::vector<symbols::Statement> values = {};  // "symbol = value"
  std::vector<symbols::Statement> true_there = {};
  std::vector<symbols::Statement> false_there;
};
[[nodiscard]] Proof by_counterexample(Counterexample example);

}  // namespace stickslip::proofs::methods
