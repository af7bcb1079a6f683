// Attractors, and orbits of words, for readers and for programs.
#pragma once

#include <string>

#include "numeric/attractors/word_search.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// As JSON, with their schemas: of attractors, the part that is about one machine. Keys that do not apply are
// absent. The verdict on an attractor is on "there is exactly one orbit there"; its state is the motion's at
// a time when the load's phase is 0, in double.
[[nodiscard]] tools::Json to_json(const numeric::attractors::AttractorList& list);
[[nodiscard]] tools::Json schema_of_attractors();
[[nodiscard]] tools::Json to_json(const numeric::attractors::WordOrbits& list);
[[nodiscard]] tools::File words_schema();

// A line for each attractor, then where they are. The parameters are those of (2) in any units, and so are
// margins.
[[nodiscard]] std::string terminal_report(const numeric::attractors::AttractorList& list,
                                          const tools::Style& style, const Units& units = {});
// Each orbit with its values, phases, stability and, of all phases, the least margin of each condition;
// formal solutions in a line each, as of the families.
[[nodiscard]] std::string terminal_report(const numeric::attractors::WordOrbits& list,
                                          const tools::Style& style, const Units& units = {},
                                          InFull in_full = InFull::admissible);

// "settles on OTS with the period 1: stable, |mu| <= 0.916".
[[nodiscard]] std::string in_words(const numeric::attractors::Attractor& attractor);

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::AttractorQuestion& question);
[[nodiscard]] std::string command_of(const numeric::attractors::WordSearch& question);

}  // namespace stickslip::report::orbits
