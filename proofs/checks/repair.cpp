#include "proofs/checks/repair.hpp"

#include "proofs/checks/edits.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

using namespace methods;
using namespace symbols;

namespace {

Outcome outcome_on(Prover& prover, Claim claim, const Statement& statement) {
  claim.printed = {statement};
  return claim.prove(prover, claim);
}

// Whether the proof has refuted an edited statement by the theorem that refutes the printed one: it does not
// look at what is printed.
bool same_refutation(const Outcome& edited, const Outcome& printed) {
  return edited.theorems.size() == 1 && printed.theorems.size() == 1 &&
         edited.theorems.front().conclusion() == printed.theorems.front().conclusion();
}

}  // namespace

std::vector<Repair> repairs(Prover& prover, const Claim& claim, const Statement& statement,
                            const Outcome& refuted) {
  std::vector<Repair> found;
  for (const Edit& edit : edits(statement)) {
    if (equal(edit.statement.left, edit.statement.right)) {
      continue;  // which says nothing
    }
    const Outcome outcome = outcome_on(prover, claim, edit.statement);
    if (same_refutation(outcome, refuted)) {
      return found;
    }
    if (outcome.verdict.truth == Truth::proved) {
      found.push_back({edit.what, edit.statement});
    }
  }
  return found;
}

void repair(Prover& prover, Record& record) {
  std::vector<Statement> corrected;
  for (const Statement& statement : record.claim.printed) {
    if (record.claim.printed.size() > 1 &&
        outcome_on(prover, record.claim, statement).verdict.truth == Truth::proved) {
      corrected.push_back(statement);
      continue;
    }
    const std::vector<Repair> found = repairs(prover, record.claim, statement, record.outcome);
    if (found.empty()) {
      return;
    }
    corrected.push_back(found.front().statement);
    record.repairs.insert(record.repairs.end(), found.begin(), found.end());
  }
  Claim reading = record.claim;
  reading.printed = corrected;
  record.claim.corrected = corrected;
  record.corrected = reading.prove(prover, reading);
}

}  // namespace stickslip::proofs::checks
