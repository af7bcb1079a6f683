#include "tests/proofs/checks/decided.hpp"

#include "proofs/pascal2012/paper.hpp"

namespace stickslip::proofs {

using namespace proofs::methods;
using namespace proofs::pascal2012;

Prover& the_prover() {
  static const std::vector<Claim> claims = paper().claims;
  static Prover prover(claims);
  return prover;
}

const Record& record(const std::string& id) {
  return the_prover().prove(id);
}

std::set<std::string> hypotheses(const std::string& id) {
  std::set<std::string> texts;
  for (const Hypothesis& hypothesis : record(id).outcome.hypotheses) {
    texts.insert(hypothesis.text);
  }
  return texts;
}

}  // namespace stickslip::proofs
