// Formulas without variables, but for square roots of numbers: whether they hold, as theorems. Inequalities
// are decided in balls, equations by normal form and in the algebra of such roots (algebraic_numbers.hpp).
#pragma once

#include <map>
#include <vector>

#include "proofs/kernel/term.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// Variables that are roots: numbers that they lie between, and x² = a as theorems, each after those of the
// roots that its a speaks of.
struct KnownRoots {
  kernel::Ranges ranges = {};
  std::vector<Theorem> squares = {};
};

// The formula, made of relations between numbers and matrices by and, or, not, and of rates (slopes.hpp).
// Throws KernelError where it is false or not decided: it has a variable or another quantifier, two numbers
// are too close to tell, or are equal and no normal form says so.
// The theorem rests on l <= x and x <= u for variables in ranges, and on their squares' hypotheses.
[[nodiscard]] Theorem certainly(const Formula& formula, const KnownRoots& roots = {});
// Its negation.
[[nodiscard]] Theorem certainly_not(const Formula& formula, const KnownRoots& roots = {});
// The theorem less those of its hypotheses that are of this kind and hold, but for the ranges. Throws
// KernelError where one of the hypotheses is not decided.
[[nodiscard]] Theorem without_hypotheses(const Theorem& theorem, const KnownRoots& roots = {});

// Terms in floating point at a point that is made up: what is not even nearly zero there need not be tried.

// Whether the sum of the terms, of one shape, is nearly zero once these definitions are opened, beside the
// largest of them. Variables, and applications of functions and of all other definitions, have values that
// depend on nothing but their name and arguments. True proves nothing; false only advises against a proof.
[[nodiscard]] bool seems_zero(const std::vector<kernel::Term>& parts, const kernel::Definitions& unfolded);

// A number nearly, all definitions opened, where these variables have these values, and all others made up.
using Point = std::map<kernel::Variable, Rational, kernel::Before>;
[[nodiscard]] long double estimated(const kernel::Term& number, const Point& values);

}  // namespace stickslip::proofs::tactics
