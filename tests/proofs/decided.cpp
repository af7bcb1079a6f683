#include "tests/proofs/decided.hpp"

#include "proofs/paper.hpp"
#include "proofs/prover.hpp"

namespace stickslip::proofs {

const Record& record(const std::string& id) {
  static const std::vector<Claim> claims = paper();
  static Prover prover(claims);
  return prover.prove(id);
}

std::set<std::string> hypotheses(const std::string& id) {
  std::set<std::string> texts;
  for (const Hypothesis& hypothesis : record(id).outcome.hypotheses) {
    texts.insert(hypothesis.text);
  }
  return texts;
}

}  // namespace stickslip::proofs
