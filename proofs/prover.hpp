// Proves claims in the order in which they need each other.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "proofs/claim.hpp"

namespace stickslip::proofs {

class Prover {
 public:
  explicit Prover(const std::vector<Claim>& claims);

  // The record of a claim, proved now unless it was before. Throws InternalError for an unknown id and for a
  // proof that comes back to its own claim.
  const Record& prove(const std::string& id);

  [[nodiscard]] const Claim& claim(const std::string& id) const;

 private:
  std::map<std::string, const Claim*> claims_;
  std::map<std::string, Record> records_;
  std::vector<std::string> under_way_;
};

// What a claim offers as a premise: the form that was proved, as printed or corrected. The caller records the
// id.
[[nodiscard]] const std::vector<Statement>& proved_form(const Record& record);

// Hypotheses joined without repetition, in order of their text.
[[nodiscard]] std::vector<Hypothesis> joined(std::vector<Hypothesis> a, const std::vector<Hypothesis>& b);
[[nodiscard]] Hypothesis hypothesis(const GiNaC::ex& nonzero);

}  // namespace stickslip::proofs
