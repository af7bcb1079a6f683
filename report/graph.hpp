// Which claim uses which, as a picture.
#pragma once

#include <string>

#include "proofs/claim.hpp"

namespace stickslip::report {

// The graph for Graphviz: a node for every claim, in a frame for its place, its class the status, its link
// the claim on the page of statements; an arrow from what is used to what uses it, unless a longer way says
// so already.
[[nodiscard]] std::string graph_script(const proofs::Audit& audit);

// Throws InputOutputError unless Graphviz is there.
void require_graphviz();

// "2.43.0 (0)".
[[nodiscard]] std::string graphviz_version();

// The graph as an SVG element to stand in a page. Throws InputOutputError when Graphviz fails.
[[nodiscard]] std::string graph_svg(const proofs::Audit& audit);

}  // namespace stickslip::report
