// What a verdict of the kernel has to be before anyone hears of it, whatever method it comes from.
#pragma once

#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

// Compares an outcome with the claim itself, whose statements are read anew.
//
// Proved: a theorem for each statement, in their order, whose conclusion is what the statement says; of a
// claim in words, theorems. Hypotheses are formulas that the claim assumes, the parameters' domain, or d ≠ 0
// of something divided by, which the outcome has to report; of a claim in words, ranges of letters, too.
// Refuted: a theorem that there are values, in the domain, with all that the claim assumes, and with which
// one of the statements fails; of a claim in words, that there are values.
//
// Throws InternalError, naming the claim and what is not so. What was decided in balls outside the kernel,
// and has no theorem, passes: its status says so.
void pass_gate(Prover& prover, const Claim& claim, const std::vector<symbols::Statement>& form,
               const Outcome& outcome);

// What the claim assumes, and the domain of the parameters of which that speaks.
[[nodiscard]] kernel::Formulas assumed_by(const Claim& claim);

// Whether the theorem rests on nothing and says that there are values, perhaps a motion, with which all of
// these hold at once.
[[nodiscard]] bool says_that_there_are_values(const kernel::Theorem& theorem, const kernel::Formulas& all);

}  // namespace stickslip::proofs::methods
