// Attractors for readers and for programs.
#pragma once

#include <string>

#include "numeric/attractors/attractors.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// As JSON, with its schema, the part that is about one machine. Keys that do not apply are
// absent. The verdict on an attractor is on "there is exactly one orbit there"; its state is the motion's at
// a time when the load's phase is 0, in double.
[[nodiscard]] tools::Json to_json(const numeric::attractors::AttractorList& list);
[[nodiscard]] tools::Json schema_of_attractors();

// A line for each attractor, then where they are. The parameters are those of (2) in any units, and so are
// margins.
[[nodiscard]] std::string terminal_report(const numeric::attractors::AttractorList& list,
                                          const tools::Style& style, const Units& units = {});

// "settles on OTS with the period 1: stable, |mu| <= 0.916".
[[nodiscard]] std::string in_words(const numeric::attractors::Attractor& attractor);

// What gives the same result again.
[[nodiscard]] std::string command_of(const numeric::attractors::AttractorQuestion& question);

}  // namespace stickslip::report::orbits
