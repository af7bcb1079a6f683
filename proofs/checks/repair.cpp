#include "proofs/checks/repair.hpp"

#include "proofs/checks/edits.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

using namespace methods;
using namespace symbols;

namespace {

Verdict verdict_on(Prover& prover, Claim claim, const Statement& statement) {
  claim.printed = {statement};
  return claim.prove(prover, claim).verdict;
}

}  // namespace

std::vector<Repair> repairs(Prover& prover, const Claim& claim, const Statement& statement) {
  std::vector<Repair> found;
  for (const Edit& edit : edits(statement)) {
    if (verdict_on(prover, claim, edit.statement).truth == Truth::proved) {
      found.push_back({edit.what, edit.statement});
    }
  }
  return found;
}

void repair(Prover& prover, Record& record) {
  std::vector<Statement> corrected;
  for (const Statement& statement : record.claim.printed) {
    if (verdict_on(prover, record.claim, statement).truth == Truth::proved) {
      corrected.push_back(statement);
      continue;
    }
    const std::vector<Repair> found = repairs(prover, record.claim, statement);
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
