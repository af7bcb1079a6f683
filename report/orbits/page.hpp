// What pages on motions share.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numeric/attractors/many_starts.hpp"
#include "numeric/orbits.hpp"
#include "report/orbits/attractors/portraits.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// What the page says beside the result.
struct PageFrame {
  std::string file;                           // of the machine, if it was read from one
  std::optional<numeric::DataTaken> machine;  // in SI units, if it was given so
  Units units = {};                           // of states and pictures
};

// A section of facts, for the template _tables.html: of rows of a label and a sentence.
[[nodiscard]] tools::Json table(const char * anchor, const char * heading,
                                const std::vector<tools::Row>& rows);
[[nodiscard]] tools::Json rows_data(const std::vector<tools::Row>& rows);
// The cells of each row under their names.
[[nodiscard]] tools::Json cells(const std::vector<tools::Row>& rows, const std::vector<std::string>& names);

// What all templates of pages ask for: title, origin, the machine as the first of the "tables".
[[nodiscard]] tools::Json page_data(const PageFrame& frame, const std::string& title,
                                    const std::string& command, const std::string& precision);

// The result as a file beside the page, with the machine: what --json prints.
[[nodiscard]] tools::File json_file(const std::string& name, tools::Json json, const PageFrame& frame);

// index.html from the template, with its style sheets, before the files. Throws InputOutputError when a
// program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> with_page(const std::string& page, const tools::Json& data,
                                                 std::vector<tools::File> files);

// Pictures for pages: the same orbits for wide and narrow screens and for paper.

// gnuplot's script of one picture; empty when there is nothing to draw.
using ScriptOf = std::function<std::string(tools::PlotFormat, tools::PlotShape)>;

// STEM.svg and STEM-narrow.svg, for screens, and STEM.pdf. Without dates; none when there is nothing to draw.
// Throw InputOutputError when gnuplot is missing or fails.
[[nodiscard]] std::vector<tools::File> pictures(const ScriptOf& script, const std::string& stem);

// All three of a list, or of one of its orbits.
[[nodiscard]] std::vector<tools::File> pictures(const numeric::OrbitList& list, const std::string& stem,
                                                std::optional<std::size_t> only = std::nullopt);

// Throws InputOutputError naming the program unless everything that pages are made with is there: Node.js
// with KaTeX, and gnuplot. Called before long work whose result is a page.
void require_page_tools();

// The programs that draw: [{"name", "version"}].
[[nodiscard]] tools::Json drawn_by();

// What the templates see of lists of orbits.

// {"title", "searched", "result", "command", "parameters": [{"latex", "value_latex"}], "remarks": [text],
//  "unresolved": [{"where": [{"latex", "value"}], "reason"}],
//  "orbits": [{"number", "total", "verdict", "tell", "split", "split_latex",
//   "stability": null or {"kind", "reason"}, "multipliers": [text],
//   "values": [{"latex", "mid", "rad", "short"}],
//   "conditions": [{"id", "statement", "verdict", "verdict_words", "margin", "at", "reason_if_open"}]}]}
[[nodiscard]] tools::Json orbit_data(const Listed& listed);

// Pages on motions that were followed, one after the other with what is known of them and portraits: of any
// oscillator.

// What all have, for the template attractors.html; what a period is, and what pictures show, in words.
[[nodiscard]] tools::Json page_on_motions(const PageFrame& frame, const std::string& title,
                                          const std::string& command, int digits,
                                          const std::string& of_period, const std::string& pictures);
// A motion on it: its heading, its rows, and its portrait, if there is one.
struct MotionOnPage {
  std::string name, tone, tell;
  std::vector<tools::Row> rows;
  std::optional<Portrait> portrait;
  PortraitLabels labels = {};
};
// The motions that `of` makes of 0, 1, ...
void add_motions(tools::Json& data, std::vector<tools::File>& files, std::size_t count,
                 const std::function<MotionOnPage(std::size_t)>& of);
// How long each phase lasts, as `text` says, for the first of them.
template <class Phase, class Text>
[[nodiscard]] std::string durations_in_words(const std::vector<Phase>& phases, const char * unit,
                                             const Text& text) {
  const std::size_t shown = std::min<std::size_t>(phases.size(), 16);
  return tools::enumerated(std::span(phases).first(shown), text) + unit +
         (shown < phases.size() ? fmt::format(", and {} more", phases.size() - shown) : "");
}
// How many of them have a picture.
inline constexpr std::size_t most_pictured = 24;
// "12: 2.4 %, within 1.4 and 4.2 %".
[[nodiscard]] tools::Row row_of_starts(const numeric::attractors::Ending& ending);

}  // namespace stickslip::report::orbits
