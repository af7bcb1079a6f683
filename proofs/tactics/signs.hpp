// What the domain says of a polynomial: its sign, and which divisors that leaves.
#pragma once

#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// f ≠ 0: because the domain gives f a sign, or says so, or says it of a sine or cosine that vanishes with f;
// else {f ≠ 0} ⊢ f ≠ 0.
[[nodiscard]] Theorem factor_differs(const Polynomial& factor, const Letters& letters, const Domain& domain);

}  // namespace stickslip::proofs::tactics
