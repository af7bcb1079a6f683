// What a letter to the journal would correct.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// The corrections, from the claims as page_data() has them, in the order of the paper's statements: {"place",
// "heading": the place where it is another than before, else null, "misprint", "printed", "corrected",
// "numbers", "remark", "illegible"}. Printed numbers of one place make one.
[[nodiscard]] tools::Json errata_data(const proofs::methods::Paper& paper,
                                      const std::vector<tools::Json>& claims);

// Of the groups of hypotheses among the findings (finding_data.hpp) those that matter and of which no
// correction of their equation speaks.
[[nodiscard]] tools::Json hypotheses_to_add(const std::vector<tools::Json>& claims,
                                            const tools::Json& findings);

}  // namespace stickslip::report::audit
