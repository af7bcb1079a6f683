// Where a simulation starts, from what the user types.
#pragma once

#include "cli/arguments.hpp"
#include "cli/machine_file.hpp"
#include "numeric/attractors/attractors.hpp"
#include "numeric/simulation/record.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

struct SimulationStart {
  numeric::simulation::Start start;
  // The same machine for what proves orbits of it. Of an orbit whose ur is a result: ur to 17 digits.
  numeric::words::WordQuestion machine;
  std::string leaves = {};  // why the motion leaves the orbit that it starts at, in a sentence, if it does
};

// The state that is given, in these units, or where the example's orbit or orbit K of a family begins; what
// the options say goes before what the file says. What is in the file and a result of the family's is left
// out of it. Searches for the orbits. Throws UsageError for what is missing or malformed and for an orbit
// that there is not, DomainError as list_orbits does.
[[nodiscard]] SimulationStart simulation_start(const SimulateOptions& options, ParameterFile& file,
                                               const proofs::methods::Examples& examples,
                                               const report::orbits::Units& units);

// What the motion settles on when it goes on from the end of the record, if that can be seen within a second
// or so; nothing after an interruption.
[[nodiscard]] std::optional<numeric::attractors::Attractor> settles_on(
    const numeric::simulation::Record& record, const numeric::words::WordQuestion& machine);

}  // namespace stickslip::cli
