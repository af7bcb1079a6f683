// What a letter to the journal would correct.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// The corrections, from the claims as page_data() has them, in the order of the paper's statements: {"place",
// "heading": the place where it is another than before, else null, "misprint", "printed", "corrected",
// "numbers", "remark"}. Printed numbers of one place make one.
[[nodiscard]] tools::Json errata_data(const proofs::methods::Paper& paper,
                                      const std::vector<tools::Json>& claims);

}  // namespace stickslip::report::audit
