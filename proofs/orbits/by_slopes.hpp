// Numbers that vary little, though what they are made of varies much: bounded by their slopes, as theorems.
#pragma once

#include "proofs/orbits/enclosed_matrix.hpp"

namespace stickslip::proofs::orbits {

// Of a definition applied, of all variables' ranges ⊢ its bounds by the mean value theorem, along these
// variables in turn, from what it is at the middles of their ranges. The slopes of all definitions in it are
// definitions, too, NAME_by_x. Throws KernelError for what is no number that depends on all of them, and
// where a divisor depends on one of them, or may be zero.
[[nodiscard]] Known bounded_by_slopes(const kernel::Term& number, const std::vector<kernel::Variable>& along,
                                      const Ranges& ranges);

}  // namespace stickslip::proofs::orbits
