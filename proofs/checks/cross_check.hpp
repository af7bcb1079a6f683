// A second opinion on verdicts: what algebra decided, evaluated by two engines that know no normal form.
//
// 1. By a Schwartz–Zippel test, exactly at random rational points of the field (numeric/scalars/exact.hpp):
//    what is proved must be 0 = 0, what is refuted must not be.
// 2. In balls, at random real parameters and times, by the model's templates: what is proved must contain
//    zero in balls that are small; what is refuted must fail at the witness, for which both sides of < or !=
//    may overlap, small.
// What holds only under equations is evaluated at points where these hold, in balls (premises.hpp).
#pragma once

#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

// Evaluates all that the outcome's proof decided, and what the claim prints: where nothing but "symbol =
// value" is assumed and the premises are identities, for all values of its symbols; else where what it rests
// on holds. Points are the same on every run, and drawn again where a denominator vanishes. The outcome must
// be proved or refuted, with the premises' hypotheses. Throws InternalError, naming the claim, if an engine
// disagrees with the verdict.
[[nodiscard]] methods::CrossCheck cross_check(methods::Prover& prover, const methods::Claim& claim,
                                              const methods::Outcome& outcome);

// Whether the two sides, with what the claim assumes to be "symbol = value" put in, are disjoint balls at the
// witness, by the model's templates. Symbols that the witness does not name take any value.
[[nodiscard]] bool fails_at(const methods::Claim& claim, const symbols::Statement& statement,
                            const Witness& witness);

}  // namespace stickslip::proofs::checks
