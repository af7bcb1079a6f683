// The search for what a misprint should have been.
#pragma once

#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::checks {

// All single edits of the statement that the claim's own method proves in its place, in the order in which
// the statement is read. None where the method refutes edits as it has refuted the statement, in `refuted`,
// without a look at them.
[[nodiscard]] std::vector<methods::Repair> repairs(methods::Prover& prover, const methods::Claim& claim,
                                                   const symbols::Statement& statement,
                                                   const methods::Outcome& refuted);

// Looks for a repair of every printed statement that is refuted by itself. If each has one, the first ones
// become the record's corrected form.
void repair(methods::Prover& prover, methods::Record& record);

}  // namespace stickslip::proofs::checks
