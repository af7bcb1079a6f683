// Inequalities along a phase: for all times of it, by signs in balls on pieces, and by the derivative where
// the two sides meet at an end.
#pragma once

#include <functional>
#include <optional>

#include "proofs/orbits/phases.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::orbits {

using kernel::Ranges;  // intervals that hold numbers

// Of the ranges those of what occurs.
[[nodiscard]] Ranges ranges_in(const kernel::Term& term, const Ranges& ranges);

// Whether it is l <= x or x <= u of one of these ranges.
[[nodiscard]] bool is_range(const kernel::Formula& formula, const Ranges& ranges);

// The sign rule from these ranges, of which there may be more than occur.
[[nodiscard]] kernel::Theorem sign(const kernel::Formula& relation, const Ranges& ranges, long bits = 128);
// Whether the sign rule proves it.
[[nodiscard]] bool holds(const kernel::Formula& relation, const Ranges& ranges, long bits = 128);
// The theorem less what it divides by: by signs in these ranges.
[[nodiscard]] kernel::Theorem without_divisors(const kernel::Theorem& theorem, const Ranges& ranges);

// The largest multiple of 1/unit that is not above.
[[nodiscard]] Rational rounded_down(const Rational& value, const mpz_class& unit);

// Bounds of what the term can be, strict and no farther apart than that where the ranges allow. Throws
// KernelError where a divisor may be zero.
[[nodiscard]] kernel::Interval enclosure(const kernel::Term& term, const Ranges& ranges,
                                         const Rational& width);

// A multiple of 1/1024 above it, and not far.
[[nodiscard]] Rational above(const kernel::Term& term, const Ranges& ranges);

// l <= x, x <= u of the ranges ⊢ the inequality, or what `decide` always says, for x in pieces as small as it
// takes. Throws KernelError where that does not end.
[[nodiscard]] kernel::Theorem in_pieces(const kernel::Formula& inequality, const kernel::Variable& x,
                                        const Ranges& ranges);
[[nodiscard]] kernel::Theorem in_pieces(const kernel::Variable& x, const Ranges& ranges,
                                        const std::function<kernel::Theorem(const Ranges&)>& decide);

// A wave below a bound for all times 0 < s < duration, or from 0 <= s, or to s <= duration.
struct Below {
  model::Wave<tactics::Symbolic> wave;
  kernel::Term bound, duration;
  // That the wave is the bound at 0, at the duration: the inequality is strict there where nothing says so.
  std::optional<kernel::Theorem> meets_at_start, meets_at_end;
};

// What the ranges say, 0 < s (0 <= s), s < duration (s <= duration) ⊢ wave(s) < bound, for a variable s.
// Throws KernelError where it is not so, or not decided.
[[nodiscard]] kernel::Theorem stays_below(const Below& question, const kernel::Variable& s,
                                          const Ranges& ranges);

}  // namespace stickslip::proofs::orbits
