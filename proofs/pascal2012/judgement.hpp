// The hypotheses that the paper does not state, judged: what is true where one of them fails.
#pragma once

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// One for each claim that brings in hypotheses.
[[nodiscard]] const std::vector<methods::Judgement>& judgements();

}  // namespace stickslip::proofs::pascal2012
