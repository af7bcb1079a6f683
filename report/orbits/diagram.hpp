// Diagrams along a parameter and basins in a plane, for readers, for programs and as pictures.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/diagram.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/page.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// In all of these states are in the units; along a parameter in SI units they are in SI. The data are those
// of (2).

// A line for each value: the shares of what the starts end on.
[[nodiscard]] std::string terminal_report(const numeric::attractors::Diagram& diagram,
                                          const tools::Style& style, const Units& units = {});
// The plane, then a line for each attractor in words.
[[nodiscard]] std::string terminal_report(const numeric::attractors::Basins& basins,
                                          const tools::Style& style, const Units& units = {});

// Names, then a line for each state of each attractor at load phase 0: the parameter, attractor (1, 2, ... at
// this value), share, kind, period, word, stable (yes, no or empty), x1, x2, x1', x2'; a value outside the
// domain has its own line with that as the kind. Numbers with 17 digits.
[[nodiscard]] std::string to_csv(const numeric::attractors::Diagram& diagram, const Units& units = {});
// Names, then a line for each start: x1, x2, x1', x2', attractor (1, 2, ...), kind, period, word.
[[nodiscard]] std::string to_csv(const numeric::attractors::Basins& basins, const Units& units = {});

// The attractors on which starts in rows end, counted from `first`, and what the schema says of that.
[[nodiscard]] std::vector<std::vector<std::size_t>> rows_of_pixels(const std::vector<std::size_t>& ends,
                                                                   long columns, std::size_t first = 1);
[[nodiscard]] tools::Json pixels_schema();

[[nodiscard]] tools::Json to_json(const numeric::attractors::Diagram& diagram);
[[nodiscard]] tools::Json to_json(const numeric::attractors::Basins& basins);
// Of these, and of attractors.hpp.
[[nodiscard]] tools::File attractors_schema();

// Scripts for gnuplot: x2 once a period against the parameter, and the plane in a colour for each attractor.
// Empty where there is nothing to draw.
[[nodiscard]] std::string plot_script(const numeric::attractors::Diagram& diagram, tools::PlotFormat format,
                                      const Units& units = {});
[[nodiscard]] std::string plot_script(const numeric::attractors::Basins& basins, tools::PlotFormat format,
                                      const Units& units = {});

// What the pictures are made of, for any oscillator.
struct DrawnDiagram {
  struct State {
    numeric::attractors::Kind kind;
    double value, place;  // of the parameter, and what is drawn
  };
  std::vector<State> states;
  std::string title, parameter, place;  // names with units
  double from, to;
};
struct DrawnBasins {
  std::vector<std::array<double, 2>> starts;  // row by row
  std::vector<std::size_t> ends;              // on which attractor each of them ends, from 0
  std::vector<std::string> attractors;        // in words
  std::string machine, x, y;                  // names with units
  std::array<long, 2> pixels;
  std::vector<char> proved = {};  // pixels are; empty where that was not asked
};
[[nodiscard]] std::string plot_script(const DrawnDiagram& diagram, tools::PlotFormat format);
[[nodiscard]] std::string plot_script(const DrawnBasins& basins, tools::PlotFormat format);

// "0.1, 54 % OTS (1), 46 % quasi-periodic": the value and what the starts end on there.
struct DiagramLine {
  std::string value, ends;
};
[[nodiscard]] std::vector<DiagramLine> lines_of(const numeric::attractors::Diagram& diagram);

// What varies, with its unit; what the other data are.
[[nodiscard]] std::string parameter_of(const numeric::attractors::DiagramQuestion& question);
[[nodiscard]] std::vector<tools::Row> rows_of(const numeric::attractors::Diagram& diagram);
[[nodiscard]] std::string plane_in_words(const numeric::attractors::Basins& basins, const Units& units = {});

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::DiagramQuestion& question);
// Of the same, all that stands behind the machine: " --along ur 0.1..0.5 ...".
[[nodiscard]] std::string options_along(const numeric::attractors::DiagramQuestion& question);
[[nodiscard]] std::string command_of(const numeric::attractors::BasinsQuestion& question);

// x1, x2, x1', x2'.
inline constexpr std::array<const char *, 4> coordinates{"x1", "x2", "x1'", "x2'"};

// What a machine does as a page for the browser, with pictures.

// The files of one directory: index.html with its style sheets, attractors.json, basins.json or
// diagram.json, but of a diagram along a value in SI units, and the pictures: of each attractor, as far as
// there are not more than most_pictured, its phase portraits and section, portrait-K.svg and
// portrait-K-narrow.svg; basins.svg; diagram.svg. A page on starts shows the basins beside them, if there are
// some. Throws InputOutputError if a program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::AttractorList& list,
                                             const std::optional<numeric::attractors::Basins>& basins,
                                             const PageFrame& frame = {});
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::Basins& basins,
                                             const PageFrame& frame = {});
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::Diagram& diagram,
                                             const PageFrame& frame = {});

inline constexpr std::size_t most_pictured = 24;

}  // namespace stickslip::report::orbits
