// Which claim uses which, as a picture.
#pragma once

#include <string>

#include "proofs/methods/paper.hpp"

namespace stickslip::report::audit {

// The graph for Graphviz: a node for every claim, in a frame for its place, its class the status, its link
// the claim on the page of statements; an arrow from what is used to what uses it, unless a longer way says
// so already.
[[nodiscard]] std::string graph_script(const proofs::methods::Paper& paper,
                                       const proofs::methods::Audit& audit);

// The graph as an SVG element to stand in a page. Throws InputOutputError when Graphviz fails.
[[nodiscard]] std::string graph_svg(const proofs::methods::Paper& paper, const proofs::methods::Audit& audit);

}  // namespace stickslip::report::audit
