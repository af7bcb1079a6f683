// Attractors for readers and for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/attractors/diagram.hpp"
#include "report/orbits/attractors/many_starts.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// As JSON. Keys that do not apply are absent. The verdict on an attractor is on "there is exactly one orbit
// there"; its state is the motion's at a time when the load's phase is 0, in double. States and durations are
// in the units, the data those of (2).
[[nodiscard]] tools::Json to_json(const numeric::attractors::AttractorList& list, const Units& units = {});

// A line for each attractor, then where they are. The parameters are those of (2) in any units, and so are
// margins.
[[nodiscard]] std::string terminal_report(const numeric::attractors::AttractorList& list,
                                          const tools::Style& style, const Units& units = {});

// "settles on OTS with the period 1: stable, |mu| <= 0.916".
[[nodiscard]] std::string in_words(const numeric::attractors::Attractor& attractor);

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::AttractorQuestion& question);

// Attractors of the paper's oscillator, diagrams along a parameter and basins in a plane: what is told of
// them (many_starts.hpp), for programs and as pages.

// States are in the units; along a parameter in SI units they are in SI. The data are those of (2). In a
// diagram x2 is drawn.
[[nodiscard]] std::vector<ToldEnding> told(const std::vector<numeric::attractors::Attractor>& all);
[[nodiscard]] ToldAlong told(const numeric::attractors::Diagram& diagram, const Units& units = {});
[[nodiscard]] ToldPlane told(const numeric::attractors::Basins& basins, const Units& units = {});

[[nodiscard]] tools::Json to_json(const numeric::attractors::Diagram& diagram, const Units& units = {});
[[nodiscard]] tools::Json to_json(const numeric::attractors::Basins& basins, const Units& units = {});
// Of all three.
[[nodiscard]] tools::File attractors_schema();

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::DiagramQuestion& question);
// Of the same, all that stands behind the machine: " --along ur 0.1..0.5 ...".
[[nodiscard]] std::string options_along(const numeric::attractors::DiagramQuestion& question);
[[nodiscard]] std::string command_of(const numeric::attractors::BasinsQuestion& question);

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

}  // namespace stickslip::report::orbits
