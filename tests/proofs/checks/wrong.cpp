#include "tests/proofs/checks/wrong.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "proofs/checks/cross_check.hpp"
#include "proofs/checks/edits.hpp"
#include "proofs/checks/mutants.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"

namespace stickslip::proofs {

using namespace proofs::checks;
using namespace proofs::methods;
using namespace proofs::symbols;
const Claim& claim_named(const std::vector<Claim>& claims, const std::string& id) {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == id; });
  if (found == claims.end()) {
    throw InternalError("no claim " + id);
  }
  return *found;
}

Mutants decide_mutants(const std::vector<Claim>& claims, const std::vector<std::string>& ids) {
  Mutants result;
  Prover nothing_else({});
  for (const std::string& id : ids) {
    for (const Statement& statement : claim_named(claims, id).printed) {
      for (const Edit& edit : edits(statement)) {
        Claim mutant = claim_named(claims, id);
        mutant.printed = {edit.statement};
        Outcome outcome = by_normal_form()(nothing_else, mutant);
        look_for_witness(outcome, nothing_else, mutant);
        const Verdict& verdict = outcome.verdict;
        if (verdict.truth == Truth::proved) {
          result.survivors.push_back(id + ": " + text(edit.statement));
        } else if (verdict.witness && fails_at(mutant, edit.statement, *verdict.witness)) {
          ++result.refuted;
        } else if (verdict.reason.find("divides by what is zero") == std::string::npos) {  // no statement
          result.open.push_back(id + ": " + text(edit.statement) + ": " + verdict.reason);
        }
      }
    }
  }
  return result;
}

Mutants decide_mutants(const std::vector<Claim>& claims, const std::string& id, const Proof& how,
                       const std::vector<Assumption>& assumptions) {
  Mutants result;
  Prover prover(claims);
  for (const Statement& statement : claim_named(claims, id).printed) {
    for (const Edit& edit : edits(statement)) {
      Claim mutant = claim_named(claims, id);
      mutant.printed = {edit.statement};
      mutant.assumptions = assumptions;
      Outcome outcome = how(prover, mutant);
      look_for_witness(outcome, prover, mutant);
      const Verdict& verdict = outcome.verdict;
      if (verdict.truth == Truth::refuted && verdict.witness) {
        ++result.refuted;
      } else {
        (verdict.truth == Truth::proved ? result.survivors : result.open)
            .push_back(id + ": " + text(edit.statement));
      }
    }
  }
  return result;
}

std::vector<std::string> proved_mutants(const std::vector<Claim>& claims, const std::vector<std::string>& ids,
                                        int& tried) {
  std::vector<std::string> survivors;
  Prover prover(claims);
  for (const std::string& id : ids) {
    const Claim& claim = claim_named(claims, id);
    for (std::size_t i = 0; i < claim.printed.size(); ++i) {
      for (const Edit& edit : edits(claim.printed[i])) {
        Claim mutant = claim;
        mutant.printed[i] = edit.statement;
        ++tried;
        if (claim.prove(prover, mutant).verdict.truth == Truth::proved) {
          survivors.push_back(id + ": " + text(edit.statement));
        }
      }
    }
  }
  return survivors;
}

}  // namespace stickslip::proofs
