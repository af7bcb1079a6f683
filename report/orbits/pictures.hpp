// Pictures for pages: the same orbits for wide and narrow screens and for paper.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/orbits.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// gnuplot's script of one picture; empty when there is nothing to draw.
using ScriptOf = std::function<std::string(tools::PlotFormat, tools::PlotShape)>;

// STEM.svg and STEM-narrow.svg, for screens; and STEM.pdf. Without dates; none when there is nothing to draw.
// Throw InputOutputError when gnuplot is missing or fails.
[[nodiscard]] std::vector<tools::File> screen_pictures(const ScriptOf& script, const std::string& stem);
[[nodiscard]] std::vector<tools::File> pictures(const ScriptOf& script, const std::string& stem);

// All three of a list, or of one of its orbits.
[[nodiscard]] std::vector<tools::File> pictures(const numeric::OrbitList& list, const std::string& stem,
                                                std::optional<std::size_t> only = std::nullopt);

// Throws InputOutputError naming the program unless everything that pages are made with is there: Node.js
// with KaTeX, and gnuplot. Called before long work whose result is a page.
void require_page_tools();

// The programs that draw: [{"name", "version"}].
[[nodiscard]] tools::Json drawn_by();

}  // namespace stickslip::report::orbits
