// Wrong statements on purpose: every single edit of every statement that is proved, put to the claim's own
// proof. All must be killed, except equivalent mutants, which are true, and those that mean nothing.
#pragma once

#include <string>
#include <vector>

#include "proofs/checks/edits.hpp"
#include "proofs/methods/claim.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

enum class Fate {
  refuted,     // killed: it fails where all that the claim rests on holds, in balls
  unproved,    // killed: the proof does not go through, with the reason; no such point was found
  stillborn,   // it does not evaluate: it divides by zero, or has no value in the model
  equivalent,  // proved, and a normal form or the points tried agree: it says what is true, too
  survived,    // proved, and nothing says that it is true
};
// As in the schema of audit.json: stillborn mutants are "meaningless" there, equivalent ones
// "true_too".
[[nodiscard]] std::string to_string(Fate fate);

struct Mutant {
  std::string claim, place;
  EditKind kind = EditKind::sign;
  std::string statement;  // as plain text, with the edit made
  Fate fate = Fate::survived;
  std::string reason;
};

// A statement written another way, at the place and for the kind of an edit: x^2 as x x, T as T/2 + T/2.
struct Twin {
  std::string claim, place;
  EditKind kind = EditKind::sign;
  std::string statement;
  Verdict verdict;  // of the claim's own proof: proved, unless that takes a statement word for word
};

struct Sampling {
  unsigned seed = 0;
  unsigned one_in = 1;  // of so many statements one is drawn; 1 takes all
};

// The mutants and twins that were drawn, in the paper's order.
struct Gate {
  Sampling sampling;
  std::vector<Mutant> mutants;
  std::vector<Twin> twins;
};

// Of the claims with these ids (all if there are none). Claims that are not proved, are no formulas or
// introduce names have neither mutants nor twins. Each mutant is put to the claim's own proof, the other
// claims being as they are, and evaluated where all holds that the claim rests on (premises.hpp).
[[nodiscard]] Gate mutant_gate(const std::vector<methods::Claim>& claims, const std::set<std::string>& ids,
                               const Sampling& sampling, const methods::Progress& progress);

// The search for what a misprint should have been.

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
