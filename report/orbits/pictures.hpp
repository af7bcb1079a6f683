// Pictures for pages: the same orbits for wide and narrow screens and for paper.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "numeric/orbits.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::orbits {

// STEM.svg, STEM-narrow.svg and STEM.pdf, without dates; none when there is no orbit to draw; of one orbit if
// one is named. Throws InputOutputError when gnuplot is missing or fails.
[[nodiscard]] std::vector<tools::File> pictures(const numeric::OrbitList& list, const std::string& stem,
                                                std::optional<std::size_t> only = std::nullopt);

// Throws InputOutputError naming the program unless everything that pages are made with is there: Node.js
// with KaTeX, gnuplot and, if asked for, Graphviz. Called before long work whose result is a page.
void require_page_tools(bool with_graph);

// The programs that draw: [{"name", "version"}].
[[nodiscard]] tools::Json drawn_by(bool with_graph);

}  // namespace stickslip::report::orbits
