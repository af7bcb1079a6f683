// Graphs drawn by Graphviz.
#pragma once

#include <string>

namespace stickslip::report::tools {

// Throws InputOutputError unless Graphviz is there.
void require_graphviz();

// "2.43.0 (0)".
[[nodiscard]] std::string graphviz_version();

// The script's graph as an SVG element to stand in a page. Throws InputOutputError when Graphviz fails.
[[nodiscard]] std::string graphviz_svg(const std::string& script);

}  // namespace stickslip::report::tools
