// Which part of the paper rests on which; which claim uses which stands with the claims.
#pragma once

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// {"parts": [{"id", "title", "short": the title without its subject, "rests_on": [{"id", "title"}], "row":
// [{"short", "count", "weight"}]}]}: a part for every place; its row has for every place how many of its
// claims the proofs of the part use ("" if none), and 1 to 4 by how many these are (0 if none).
[[nodiscard]] tools::Json uses_of_places(const proofs::methods::Paper& paper,
                                         const proofs::methods::Audit& audit);

}  // namespace stickslip::report::audit
