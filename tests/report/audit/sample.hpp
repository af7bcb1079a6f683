// An audit made by hand: one record of every kind that reports have to show.
#pragma once

#include <string>

#include "proofs/methods/paper.hpp"

namespace stickslip::report {

// A paper that does not exist, with two sections and five statements, of which one has no claim; its claims
// stand in the audit alone.
[[nodiscard]] proofs::methods::Paper sample_paper();

// Ids: 2 (model), 5 (as printed), 5.where (needs a hypothesis), 44 (misprint, witness), S.tau (digits off),
// 17 (undecided, and not the paper's). Words and reasons contain characters that HTML and TeX treat
// specially.
[[nodiscard]] proofs::methods::Audit sample_audit();

// Whether the text holds the part.
[[nodiscard]] inline bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace stickslip::report
