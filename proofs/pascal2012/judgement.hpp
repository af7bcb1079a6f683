// The hypotheses that the paper does not state, judged: what is true where one of them fails.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace stickslip::proofs::pascal2012 {

struct Judgement {
  std::string origin;              // id of the claim whose proof divides by it
  bool matters = true;             // the paper's result is lost where it fails
  std::string words;               // what is true there, or which proof does without it
  std::set<std::string> shown_by;  // ids of the claims that show that
};

// One for each claim that brings in hypotheses.
[[nodiscard]] const std::vector<Judgement>& judgements();

}  // namespace stickslip::proofs::pascal2012
