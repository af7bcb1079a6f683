// Matrices of four rows that are known entry by entry, and their products, as theorems.
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
