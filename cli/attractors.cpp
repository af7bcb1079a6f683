// stickslip attractors: what a machine does. stickslip orbits WORD: orbits through given phases.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/commands.hpp"
#include "cli/machine_file.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "cli/output.hpp"
#include "core/interruption.hpp"
#include "report/orbits/attractors.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::attractors;
using words::WordOrbit;

namespace {

constexpr int most_periods_of_word = 100000;

int digits_of(const std::string& text) {
  return whole_number("digits", text, OrbitsOptions::most_digits, OrbitsOptions::default_digits);
}

// Whether existence, all conditions and, where they hold, stability are decided.
bool is_decided(const WordOrbit& o) {
  return o.existence.truth == Truth::proved &&
         (o.orbit.admissible.truth == Truth::refuted ||
          (o.orbit.admissible.truth == Truth::proved &&
           o.orbit.stability->kind != motion::StabilityKind::undecided));
}

template <class Result>
void print_result(const Result& result, const ParameterFile& file, const report::orbits::Units& units,
                  bool json) {
  print(json ? report::tools::to_text(with_machine(report::orbits::to_json(result), file))
             : machine_report(file) + report::orbits::terminal_report(result, terminal_style(), units));
}

}  // namespace

ExitCode run(const AttractorsOptions& options, const proofs::methods::Paper& paper) {
  const auto whole = [](const char * name, const std::string& text, int otherwise) {
    return whole_number(name, text, AttractorsOptions::greatest_number, otherwise);
  };
  const ParameterFile file =
      read_parameters(options.file, options.parameters, options.example, FrictionAtRest::needed);
  const report::orbits::Units units = units_of(options.units, file, options.json);
  const AttractorQuestion question{
      machine(paper, options.parameters, file.parameters, options.example, digits_of(options.digits)),
      whole_number("starts", options.starts, AttractorsOptions::most_starts,
                   AttractorsOptions::default_starts),
      static_cast<std::uint64_t>(whole("seed", options.seed, 1)),
      whole("most-periods", options.most_periods, AttractorsOptions::default_most_periods)};
  const Jobs limit = jobs(options.jobs);
  const AttractorList list = [&] {
    const Interruptible scope;
    const Progress progress("following the starts ...");
    return find_attractors(question);
  }();
  print_result(list, file, units, options.json);
  if (list.interrupted) {
    return exit_interrupted;
  }
  const bool decided = std::all_of(list.attractors.begin(), list.attractors.end(), [](const Attractor& a) {
    return a.kind != Kind::periodic || (a.orbit && is_decided(*a.orbit));
  });
  return decided ? exit_decided : exit_undecided;
}

ExitCode run_word(const OrbitsOptions& options, const proofs::methods::Paper& paper) {
  const words::Word word = words::Word::parse(options.family);
  if (options.with_plot || options.with_out) {
    throw UsageError("--plot and --out draw the orbits of a family; those of a word are printed only");
  }
  const ParameterFile file =
      read_parameters(options.file, options.parameters, options.example, FrictionAtRest::needed);
  const report::orbits::Units units = units_of(options.units, file, options.json);
  WordSearch search{
      machine(paper, options.parameters, file.parameters, options.example, digits_of(options.digits)),
      word,
      whole_number("period", options.period, most_periods_of_word, 1),
      {}};
  if (options.with_near) {
    search.near = four_numbers("near", options.near);
  }
  const Jobs limit = jobs(options.jobs);
  const WordOrbits list = [&] {
    const Interruptible scope;
    const Progress progress("searching for orbits ...");
    return find_word_orbits(search);
  }();
  print_result(list, file, units, options.json);
  if (list.interrupted) {
    return exit_interrupted;
  }
  const bool decided = std::all_of(list.orbits.begin(), list.orbits.end(), is_decided);
  const bool answered = list.searched ? list.complete() : !list.orbits.empty();
  return decided && answered ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
