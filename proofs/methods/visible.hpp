// Whether who reads a formula sees where it has no meaning.
#pragma once

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// Whether the claim that brought the hypothesis in prints a division, or a tangent, by something that is zero
// where the hypothesis fails. Of another claim only what a source prints is seen, none of our own formulas.
[[nodiscard]] bool is_seen(const Hypothesis& hypothesis, const Claim& needing, const Claim& origin);

}  // namespace stickslip::proofs::methods
