// A second opinion on verdicts: what algebra decided, evaluated by two engines that know no normal form.
//
// 1. Exactly, at random rational points of the field (numeric/exact.hpp): what is proved must be 0 = 0, what
//    is refuted must not be.
// 2. In balls, at random real parameters and times, by the model's templates: what is proved must contain
//    zero in balls that are small; the two sides of what is refuted must be disjoint at the witness.
// Formulas are evaluated as terms, not through GiNaC, except those that GiNaC derived.
#pragma once

#include <string>

#include "proofs/claim.hpp"

namespace stickslip::proofs {

// Evaluates all that the outcome's proof decided, and what the claim prints, where that holds for all values
// of its symbols: nothing but "symbol = value" is assumed, and the premises hold like that too
// (`identities`). Printed inequalities are evaluated in balls where the inequalities that they assume hold.
// Points are the same on every run, and drawn again where a denominator vanishes. The outcome must be proved
// or refuted. Throws InternalError, naming the claim, if an engine disagrees with the verdict.
[[nodiscard]] CrossCheck cross_check(const Claim& claim, const Outcome& outcome, bool identities);

// Whether the two sides, with what the claim assumes to be "symbol = value" put in, are disjoint balls at the
// witness, by the model's templates. Symbols that the witness does not name take any value.
[[nodiscard]] bool fails_at(const Claim& claim, const Statement& statement, const Witness& witness);

}  // namespace stickslip::proofs
