// Kernel terms of numbers as they are printed.
#pragma once

#include <string>

#include "proofs/kernel/term.hpp"
#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// Both throw symbols::NoValue for what has no print, a function of time applied or an entry of a vector.

// As it is built.
[[nodiscard]] symbols::Term printed_term(const kernel::Term& number);
// As a quotient of sums of monomials, those of low degree first; so are the arguments of cosines and sines.
// Throws KernelError where that would take too long.
[[nodiscard]] symbols::Term neat_term(const kernel::Term& number);

// That the factor is not zero: of f and -f the one whose first term is positive. `origin` is the id of the
// claim whose proof divides by it.
[[nodiscard]] Hypothesis hypothesis(const kernel::Term& factor, const std::string& origin);

}  // namespace stickslip::proofs::methods
