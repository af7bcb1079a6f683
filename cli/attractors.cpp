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

// Whether existence, all conditions and, where they hold, stability are decided.
bool is_decided(const WordOrbit& o) {
  return o.existence.truth == Truth::proved &&
         (o.orbit.admissible.truth == Truth::refuted ||
          (o.orbit.admissible.truth == Truth::proved &&
           o.orbit.stability->kind != motion::StabilityKind::undecided));
}

// The machine that is asked about, and how its motions are told.
struct Asked {
  ParameterFile file;
  report::orbits::Units units;
  words::WordQuestion machine;
  Jobs limit;
  bool json;
};

template <class Options>
Asked asked(const Options& options, const proofs::methods::Paper& paper) {
  ParameterFile file =
      read_parameters(options.file, options.parameters, options.example, FrictionAtRest::needed);
  leave_out(file, "phi", "the load is cos(omega t), and where in it an orbit begins is a result");
  const int digits =
      whole_number("digits", options.digits, OrbitsOptions::most_digits, OrbitsOptions::default_digits);
  return {file, units_of(options.units, file, options.json),
          machine(paper, options.parameters, file.parameters, options.example, digits), jobs(options.jobs),
          options.json};
}

template <class Result>
void print_result(const Result& result, const Asked& asked) {
  tell_left_out(asked.file);
  print(asked.json ? report::tools::to_text(with_machine(report::orbits::to_json(result), asked.file))
                   : machine_report(asked.file) +
                         report::orbits::terminal_report(result, terminal_style(), asked.units));
}

}  // namespace

ExitCode run(const AttractorsOptions& options, const proofs::methods::Paper& paper) {
  if (!options.along.empty() || !options.plane.empty()) {
    return run_diagram(options, paper);
  }
  for (const auto& [name, text] :
       {std::pair("--values", &options.values), std::pair("--pixels", &options.pixels),
        std::pair("--through", &options.through), std::pair("--csv", &options.csv),
        std::pair("--plot", &options.plot)}) {
    if (!text->empty()) {
      throw UsageError(fmt::format("{} is for --along and --plane", name));
    }
  }
  const auto whole = [](const char * name, const std::string& text, int otherwise) {
    return whole_number(name, text, AttractorsOptions::greatest_number, otherwise);
  };
  const Asked given = asked(options, paper);
  const AttractorQuestion question{
      given.machine,
      whole_number("starts", options.starts, AttractorsOptions::most_starts,
                   AttractorsOptions::default_starts),
      static_cast<std::uint64_t>(whole("seed", options.seed, 1)),
      whole("most-periods", options.most_periods, AttractorsOptions::default_most_periods)};
  const AttractorList list = [&] {
    const Interruptible scope;
    const Progress progress("following the starts ...");
    return find_attractors(question);
  }();
  print_result(list, given);
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
  const Asked given = asked(options, paper);
  WordSearch search{given.machine,
                    word,
                    whole_number("period", options.period, OrbitsOptions::most_periods_of_word, 1),
                    {}};
  if (options.with_near) {
    search.near = four_numbers("near", options.near);
  }
  const zeros::Effort patience = effort(options);
  const WordOrbits list = [&] {
    const Interruptible scope;
    const Progress progress("searching for orbits ...");
    return find_word_orbits(search);
  }();
  print_result(list, given);
  if (list.interrupted) {
    return exit_interrupted;
  }
  const bool decided = std::all_of(list.orbits.begin(), list.orbits.end(), is_decided);
  const bool answered = list.searched ? list.complete() : !list.orbits.empty();
  return decided && answered ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
