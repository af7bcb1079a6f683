// Signs of terms in which definitions stand: what each of these is, is bounded first, one after the other, so
// that no term is longer than one of them.
#pragma once

#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::orbits {

// Of all variables' ranges, of which there may be more than occur, ⊢ the relation: <, <=, or two numbers that
// differ. Throws KernelError where the bounds do not decide it.
[[nodiscard]] kernel::Theorem sign_by_parts(const kernel::Formula& relation, const Ranges& ranges);

// Of ranges as there, ⊢ that a number lies between bounds that are as near as they allow.
[[nodiscard]] Known bounded_by_parts(const kernel::Term& number, const Ranges& ranges);

// ⊢ for all x between its ends …: C, of these variables in turn, the first outermost; from ranges ⊢ C.
[[nodiscard]] kernel::Theorem for_all_in(const kernel::Theorem& theorem,
                                         const std::vector<kernel::Variable>& variables,
                                         const Ranges& ranges);

}  // namespace stickslip::proofs::orbits
