// Products that are not negative.
#pragma once

#include "proofs/methods/derivation.hpp"

namespace stickslip::proofs::methods {

// 0 ≤ a, for the kernel's rule `order`: a as a positive number times a square times what is positive. All
// definitions are looked into. Throws KernelError where the sign of a factor is not known.
[[nodiscard]] kernel::Positive not_negative(Derivation& derivation, const kernel::Term& a);

}  // namespace stickslip::proofs::methods
