// From the options of a command about a machine to what is asked: for the program and for the Python module.
// Each throws UsageError for what is missing, malformed or does not go together, InputOutputError when the
// file cannot be read, DomainError as numeric::data_taken does.
#pragma once

#include "cli/answers/machine_file.hpp"
#include "cli/arguments/arguments.hpp"
#include "numeric/atlas/question.hpp"
#include "numeric/attractors/diagram.hpp"
#include "numeric/attractors/word_search.hpp"
#include "numeric/branches/branches.hpp"
#include "numeric/orbits.hpp"
#include "numeric/simulation/record.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

// The file, with what does not count left out; in which units results are told, and states are given.
template <class Question>
struct Asked {
  ParameterFile file;
  report::orbits::Units units;
  Question question;
};

// Of an answer that is in SI units in JSON, too.
template <class Options>
[[nodiscard]] Options as_text(Options options) {
  options.json = false;
  return options;
}

// Of a family; of a word with events; of a word of one phase.
[[nodiscard]] Asked<numeric::OrbitQuestion> asked_orbits(const OrbitsOptions& options,
                                                         const proofs::methods::Examples& examples);
[[nodiscard]] Asked<numeric::attractors::WordSearch> asked_word(const OrbitsOptions& options,
                                                                const proofs::methods::Examples& examples);
[[nodiscard]] Asked<numeric::words::WordQuestion> asked_pure_word(const OrbitsOptions& options,
                                                                  const proofs::methods::Examples& examples);

// Of a family or a word. The branches of a word begin with orbits that are searched for. Along a value of a
// machine in SI units the question has the machine, and all is in SI units.
[[nodiscard]] Asked<numeric::branches::BranchQuestion> asked_branch(
    const BranchOptions& options, const proofs::methods::Examples& examples);
// The machine in the middle of a box, of which several data vary.
[[nodiscard]] Asked<numeric::words::WordQuestion> asked_box(const BranchOptions& options,
                                                            const proofs::methods::Examples& examples);

// Whether the options of --along and --plane go together, and with neither of them; what these ask by
// default. Throw UsageError.
void require_sense(const AttractorsOptions& options);
[[nodiscard]] int values_of(const AttractorsOptions& options);
[[nodiscard]] int pixels_of(const AttractorsOptions& options);

// Without --along and --plane; with one of them.
[[nodiscard]] Asked<numeric::attractors::AttractorQuestion> asked_attractors(
    const AttractorsOptions& options, const proofs::methods::Examples& examples);
[[nodiscard]] Asked<numeric::attractors::DiagramQuestion> asked_diagram(
    const AttractorsOptions& options, const proofs::methods::Examples& examples);
[[nodiscard]] Asked<numeric::attractors::BasinsQuestion> asked_basins(
    const AttractorsOptions& options, const proofs::methods::Examples& examples);

// Of a machine in SI units, whose values may be ranges, the question is in these.
[[nodiscard]] Asked<numeric::atlas::Question> asked_atlas(const AtlasOptions& options,
                                                          const proofs::methods::Examples& examples);

// Where a simulation starts.
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

// A motion: how many periods of the load, and the time between samples, in the units of the data.
struct MotionAsked {
  SimulationStart from;
  double periods = 0, every = 0;

  [[nodiscard]] double period() const;  // of the load
};
// Searches for the orbit where it starts at one.
[[nodiscard]] Asked<MotionAsked> asked_motion(const SimulateOptions& options,
                                              const proofs::methods::Examples& examples);

}  // namespace stickslip::cli
