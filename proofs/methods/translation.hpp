// Terms of the kernel and expressions of GiNaC, in which hypotheses are named and rewriting is found.
#pragma once

#include "proofs/methods/reading.hpp"
#include "symbolic/algebra/decide.hpp"

namespace stickslip::proofs::methods {

// The term's entries with all definitions opened. Throws KernelError for what is of functions, or an inverse
// of more than two rows.
[[nodiscard]] symbolic::algebra::Matrix expression(const kernel::Term& term);

// A rational function of scalars, their cosines and sines. Throws KernelError for anything else.
[[nodiscard]] kernel::Term term_of(const GiNaC::ex& scalar, Reader& read);

}  // namespace stickslip::proofs::methods
