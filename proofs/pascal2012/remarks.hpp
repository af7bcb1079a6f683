// The remarks on the paper, and the results of its audit.
#pragma once

#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// On each claim of the paper that is refuted, misprinted, or necessary and not sufficient, and on what the
// paper takes for granted and is not so; the weightiest first.
[[nodiscard]] std::vector<methods::Remark> remarks();

// What the audit found beyond the paper, to be cited; the strongest first.
[[nodiscard]] std::vector<methods::Result> results();

}  // namespace stickslip::proofs::pascal2012
