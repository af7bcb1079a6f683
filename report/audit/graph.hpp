// Which part of the paper rests on which, as a picture; which claim uses which stands with the claims.
#pragma once

#include <string>

#include "proofs/methods/paper.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// {"parts": [{"id", "title", "lines": title and count of claims, "rests_on": [{"id", "title"}]}], "uses":
// [{"from", "to", "width"}]}: a part for every place, and a use for each two of which the second's proofs use
// claims of the first, the wider the more they use.
[[nodiscard]] tools::Json uses_of_places(const proofs::methods::Paper& paper,
                                         const proofs::methods::Audit& audit);

// The script for Graphviz: a node for every part, whose link is the place on the page of claims, and an arrow
// for every use.
[[nodiscard]] std::string graph_script(const tools::Json& uses);

// The graph as an SVG element to stand in a page. Throws InputOutputError when Graphviz fails.
[[nodiscard]] std::string graph_svg(const tools::Json& uses);

}  // namespace stickslip::report::audit
