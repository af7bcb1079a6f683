// Which part of the paper rests on which, as a picture; which claim uses which stands with the claims.
#pragma once

#include <string>

#include "proofs/methods/paper.hpp"

namespace stickslip::report::audit {

// The graph for Graphviz: a node for every place, with the count of its claims, its link the place on the
// page of claims; an arrow from a place to another whose proofs use claims of it, the wider the more they
// use.
[[nodiscard]] std::string graph_script(const proofs::methods::Paper& paper,
                                       const proofs::methods::Audit& audit);

// The graph as an SVG element to stand in a page. Throws InputOutputError when Graphviz fails.
[[nodiscard]] std::string graph_svg(const proofs::methods::Paper& paper, const proofs::methods::Audit& audit);

}  // namespace stickslip::report::audit
