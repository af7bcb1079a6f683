// Square roots in ranges: the kernel has no term for them, and a variable of which only that is known has
// one.
#pragma once

#include <optional>
#include <vector>

#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// The root of a number in floating point, that of one that is negative by rounding alone being 0; else NaN.
[[nodiscard]] long double nearly_root(long double square);

class Roots {
 public:
  // The variable, of which theorems say x² = a and 0 ≤ x, in a range about what floating point says. No
  // variable is in a but those added before. Throws KernelError where a is negative, or that is not decided.
  void add(const Theorem& square, const Theorem& not_negative);

  [[nodiscard]] bool contains(const Variable& x) const { return known_.ranges.contains(x); }
  // Whether all variables of the term are among them.
  [[nodiscard]] bool know(const Term& term) const;
  // For certainly() and its like, whose theorems rest on their ranges.
  [[nodiscard]] const KnownRoots& known() const { return known_; }
  // The theorem on what add() was given in place of the ranges: of all, of that variable.
  [[nodiscard]] Theorem without_ranges(Theorem theorem) const;
  [[nodiscard]] Theorem without_range(const Variable& x, const Theorem& theorem) const;

  // The rational number that is not negative and has that square, of a term that they know; nothing where
  // none of small denominator has.
  [[nodiscard]] std::optional<Rational> rational_root(const Term& square) const;

 private:
  struct Bounds {
    Variable root;
    std::vector<Theorem> ends;
  };
  [[nodiscard]] long double near(const Term& square) const;
  [[nodiscard]] Bounds bounded(const Theorem& square, const Theorem& not_negative, const Rational& lower,
                               const Rational& upper) const;

  std::vector<Bounds> bounds_;  // each after those of which its square speaks
  KnownRoots known_;
  Point midpoints_;
};

}  // namespace stickslip::proofs::tactics
