// The search for what a misprint should have been.
#pragma once

#include <vector>

#include "proofs/claim.hpp"

namespace stickslip::proofs {

// All single edits of the statement that the claim's own method proves in its place, in the order in which
// the statement is read.
[[nodiscard]] std::vector<Repair> repairs(Prover& prover, const Claim& claim, const Statement& statement);

// Looks for a repair of every printed statement that is refuted by itself. If each has one, the first ones
// become the record's corrected form.
void repair(Prover& prover, Record& record);

}  // namespace stickslip::proofs
