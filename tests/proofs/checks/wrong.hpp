// Wrong statements: single edits of claims, and whether they are refuted or at least not proved.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs {

using namespace proofs::methods;

[[nodiscard]] const Claim& claim_named(const std::vector<Claim>& claims, const std::string& id);

struct Mutants {
  int refuted = 0;                     // with a witness that a second evaluation confirms
  std::vector<std::string> survivors;  // "id: statement", proved
  std::vector<std::string> open;       // neither, or the witness is not confirmed
};

// All single edits of the claims' statements, decided by normal form under the claims' assumptions. The
// evaluation that confirms a witness does not pass through GiNaC.
[[nodiscard]] Mutants decide_mutants(const std::vector<Claim>& claims, const std::vector<std::string>& ids);

// The same for one claim by another method, under these assumptions in place of its own; witnesses are not
// confirmed.
[[nodiscard]] Mutants decide_mutants(const std::vector<Claim>& claims, const std::string& id,
                                     const Proof& how, const std::vector<Assumption>& assumptions = {});

// All single edits that the claims' own methods prove.
[[nodiscard]] std::vector<std::string> proved_mutants(const std::vector<Claim>& claims,
                                                      const std::vector<std::string>& ids, int& tried);

}  // namespace stickslip::proofs
