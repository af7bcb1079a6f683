// What commands answer about a machine in tables: for the program and for the Python module. Each throws
// UsageError for options that do not go with one, and as the search does.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/answers/machine_file.hpp"
#include "cli/answers/machine_tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "core/error.hpp"
#include "numeric/words/word_orbit.hpp"
#include "proofs/methods/paper.hpp"
#include "report/machines/results.hpp"

namespace stickslip::cli {

// A machine, and its numbers by their paths.
struct GivenInTables {
  report::machines::Origin origin;
  numeric::machines::Machine machine;
  // With other numbers; what is given there. Throw UsageError for a path that no number that can vary has.
  std::function<numeric::machines::Machine(const std::vector<Datum>&)> with = {};
  std::function<Rational(const std::string&)> value = {};
};

// The paper's oscillator as one, its data under their names. A machine in SI units is one in these, where
// `why`, an option, is asked for in them: else UsageError.
[[nodiscard]] GivenInTables as_tables(const numeric::words::WordQuestion& machine, const ParameterFile& file,
                                      const report::orbits::Units& units, const char * why);
// What is then asked of it: nothing beside says what it is.
template <class Options>
[[nodiscard]] Options without_machine(Options options) {
  options.example.clear();
  options.parameters.clear();
  options.si = false;
  return options;
}
// For several --along, and what is then asked of it. Throws UsageError for a family of orbits.
[[nodiscard]] std::pair<GivenInTables, BranchOptions> box_in_tables(
    const BranchOptions& o, const proofs::methods::Examples& examples);
// Nothing if no file is given, or the file is none of these.
[[nodiscard]] std::optional<GivenInTables> given_in_tables(const GivenMachine& options);

[[nodiscard]] report::machines::Attractors answer(const GivenInTables& given, const AttractorsOptions& o);
// With --along; with --plane.
[[nodiscard]] report::machines::Diagram diagram_answer(const GivenInTables& given,
                                                       const AttractorsOptions& o);
[[nodiscard]] report::machines::Basins basins_answer(const GivenInTables& given, const AttractorsOptions& o);
// Of a word.
[[nodiscard]] report::machines::WordOrbits answer(const GivenInTables& given, const OrbitsOptions& o);
// Of S: steady sliding, without a load that varies, and along a number of the file.
[[nodiscard]] report::machines::Steady steady_answer(const GivenInTables& given, const OrbitsOptions& o);
[[nodiscard]] report::machines::SteadyBranch steady_answer(const GivenInTables& given,
                                                           const BranchOptions& o);
// The branches of its orbits at --at, by default at what the file says, or in the middle where that is not in
// the interval.
[[nodiscard]] report::machines::Branches answer(const GivenInTables& given, const BranchOptions& o);
// Of several numbers: these orbits where all of them vary, looked for at what the file says.
[[nodiscard]] report::machines::OverBox box_answer(const GivenInTables& given, const BranchOptions& o);
// Each sample is handed on; the motion goes on as long as it is asked to.
using SampleOfMachine = numeric::simulation::SampleOf<numeric::simulation::AnyState>;
[[nodiscard]] report::machines::Motion answer(const GivenInTables& given, const SimulateOptions& o,
                                              const std::function<bool(double)>& go_on,
                                              const std::function<void(const SampleOfMachine&)>& take);

// S or O, for ever.
[[nodiscard]] bool is_steady(const std::string& word);
// Throws UsageError where one is given: there is none but of these.
void require_no_basin(const std::optional<std::string>& basin);

// With --set: of all motions from a box of starts.
[[nodiscard]] report::machines::SetMotion set_answer(const GivenInTables& given, const SimulateOptions& o);

}  // namespace stickslip::cli
