// Numbers between bounds, and matrices of four rows that are known entry by entry, as theorems.
#pragma once

#include <map>
#include <vector>

#include "proofs/orbits/along.hpp"

namespace stickslip::proofs::orbits {

// A number's bounds, and theorems that it lies between them.
struct Known {
  kernel::Term value;
  kernel::Interval range;
  kernel::Theorem lower, upper;  // l <= value, value <= u
};
// Letters that stand for numbers, each with what it stands for.
using Letters = std::map<kernel::Variable, Known>;
[[nodiscard]] Ranges ranges_of(const Letters& letters);

// Ranges that are wider are halved in certificates where that gives closer bounds.
inline const Rational wide(1, 1000000);

// ranges ⊢ l <= term, term <= u, with l and u near: multiples of 2^-places. Throws KernelError where a
// divisor may be zero.
[[nodiscard]] Known bounded(const kernel::Term& term, const Ranges& ranges, int places = 28);
// What theorems bound by numbers, first l < term and later term < u, and entries that are numbers, entry = v:
// each by the first that says so.
[[nodiscard]] std::map<kernel::Term, Known> bounds_said(const std::vector<kernel::Theorem>& theorems);

// The theorem with the letters' values in their place, and without the hypotheses on their ranges.
[[nodiscard]] kernel::Theorem settled(const kernel::Theorem& theorem, const Letters& letters);

// ---- Numbers that vary little, though what they are made of varies much: bounded by their slopes
// (by_slopes.cpp).

// Signs of terms in which definitions stand: what each of these is, is bounded first, one after the other, so
// that no term is longer than one of them.

// Of all variables' ranges, of which there may be more than occur, ⊢ the relation: <, <=, or two numbers that
// differ. Throws KernelError where the bounds do not decide it.
[[nodiscard]] kernel::Theorem sign_by_parts(const kernel::Formula& relation, const Ranges& ranges);

// Of ranges as there, ⊢ that a number lies between bounds that are as near as they allow.
[[nodiscard]] Known bounded_by_parts(const kernel::Term& number, const Ranges& ranges);

// ⊢ for all x between its ends …: C, of these variables in turn, the first outermost; from ranges ⊢ C.
[[nodiscard]] kernel::Theorem for_all_in(const kernel::Theorem& theorem,
                                         const std::vector<kernel::Variable>& variables,
                                         const Ranges& ranges);

// Of a definition applied, of all variables' ranges ⊢ its bounds by the mean value theorem, along these
// variables in turn, from what it is at the middles of their ranges. The slopes of all definitions in it are
// definitions, too, NAME_by_x. Throws KernelError for what is no number that depends on all of them, and
// where a divisor depends on one of them, or may be zero.
[[nodiscard]] Known bounded_by_slopes(const kernel::Term& number, const std::vector<kernel::Variable>& along,
                                      const Ranges& ranges);

// ---- Matrices.
inline constexpr int matrix_rows = 4;
inline constexpr long matrix_bits = 96;  // of signs in balls

struct Matrix {
  kernel::Term value;
  std::vector<kernel::Interval> bounds;  // of the entries, row by row
  kernel::Theorem known;                 // that they are so: lies_between, a definition
};
// A letter for each entry of a matrix, known from its bounds, which are a hypothesis.
[[nodiscard]] Letters entries_of(const kernel::Variable& M, const std::vector<kernel::Interval>& bounds);
// The matrix with these entries, in ranges of letters, and then with the letters' values. It is another one,
// as the theorem says.
[[nodiscard]] Matrix matrix_of(const std::vector<kernel::Term>& entries, const Ranges& ranges,
                               const Letters& letters, const kernel::Theorem& is_matrix);
// A times P.
[[nodiscard]] Matrix product(const Matrix& a, const Matrix& p);

}  // namespace stickslip::proofs::orbits
