// Numbers that vary little, though what they are made of varies much: bounded by their slopes, as theorems.
#pragma once

#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::orbits {

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

}  // namespace stickslip::proofs::orbits
