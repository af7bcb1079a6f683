// The findings as the templates see them.
#pragma once

#include <vector>

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// Whether the claim compares printed numbers.
[[nodiscard]] bool compares(const tools::Json& claim);

// The groups in which a reader meets the findings, most important first: what is open; what the paper says
// and is not so, in the order of the remarks; by status, from the worst; what the paper takes for granted.
// Each
// {"title", "explanation", "count", "claims", "numbers", "hypotheses_groups": [{"hypotheses", "origins":
// [{"id", "words"}], "inherited_by", "inherited_by_count"}]}. `claims` are those of page_data.hpp, one for
// each record of the audit.
[[nodiscard]] tools::Json finding_data(const proofs::methods::Paper& paper,
                                       const proofs::methods::Audit& audit,
                                       const std::vector<tools::Json>& claims);

}  // namespace stickslip::report::audit
