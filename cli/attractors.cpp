// stickslip attractors: what a machine does. stickslip orbits WORD: orbits through given phases.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "core/interruption.hpp"
#include "numeric/attractors/settle.hpp"

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
struct AskedMachine {
  ParameterFile file;
  report::orbits::Units units;
  words::WordQuestion machine;
  Jobs limit;
  bool json;
};

template <class Options>
AskedMachine asked(const Options& options, const TypedParameters& typed,
                   const proofs::methods::Paper& paper) {
  ParameterFile file = read_parameters(options.file, typed, options.example, FrictionAtRest::needed);
  leave_out(file, "phi", "the load is cos(omega t), and where in it an orbit begins is a result");
  const int digits = digits_of(options.digits, file);
  return {file, units_of(options.units, file, options.json),
          machine(paper, typed, file.parameters, options.example, digits), jobs(options.jobs), options.json};
}

// Whether motions of one phase are possible, which has no events that a search could go through.
ExitCode run_pure(motion::PhaseKind kind, const OrbitsOptions& options, const proofs::methods::Paper& paper) {
  if (!options.period.empty() || options.with_near || options.parameters.contains("phi")) {
    throw UsageError(fmt::format(
        "--period, --near and --phi are for words with events: the motions {} have one phase for ever",
        options.family));
  }
  const AskedMachine given = asked(options, options.parameters, paper);
  words::require_machine_domain(given.machine);
  const report::orbits::PureWord word{given.machine, kind};
  print_result(word, given.file, given.json, given.units);
  return report::orbits::exists(word).truth == Truth::undecided ? exit_undecided : exit_decided;
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
  if (options.with_out) {
    require_page(options.out);
  }
  const AskedMachine given = asked(options, options.parameters, paper);
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
  std::optional<Basins> basins;
  if (options.with_out && !list.interrupted) {
    const Interruptible scope;
    const Progress progress("following starts in a plane ...");
    constexpr long pixels = AttractorsOptions::pixels_beside_starts;
    basins = basins_of({question, {0, 1}, {}, {pixels, pixels}});
  }
  if (options.with_out) {
    const Progress progress("making the page ...");
    report::tools::write_files(
        options.out, report::orbits::pages(list, basins, {given.file.name, given.file.machine, given.units}));
  }
  print_result(list, given.file, given.json, given.units);
  if (options.with_out) {
    tell(fmt::format("The report is in {}: index.html.", options.out));
  }
  if (list.interrupted) {
    return exit_interrupted;
  }
  const bool decided = std::all_of(list.attractors.begin(), list.attractors.end(), [](const Attractor& a) {
    return a.kind != Kind::periodic || (a.orbit && is_decided(*a.orbit));
  });
  return decided ? exit_decided : exit_undecided;
}

ExitCode run_word(const OrbitsOptions& options, const proofs::methods::Paper& paper) {
  if (options.with_plot || options.with_out) {
    throw UsageError("--plot and --out draw the orbits of a family; those of a word are printed only");
  }
  if (const auto kind = words::kind_of(options.family)) {
    return run_pure(*kind, options, paper);
  }
  const words::Word word = words::Word::parse(options.family);
  TypedParameters typed = options.parameters;
  const auto phase = typed.extract("phi");
  if (phase && !options.with_near) {
    throw UsageError(
        "phi is not given for a word without --near: it is the load's phase at the start that --near gives");
  }
  const AskedMachine given = asked(options, typed, paper);
  WordSearch search{given.machine,
                    word,
                    whole_number("period", options.period, OrbitsOptions::most_periods_of_word, 1),
                    {}};
  if (options.with_near) {
    search.near = at_phase_0({motion::parameters_as<double>(given.machine.data),
                              numeric::scalars::scalar<double>(given.machine.ur),
                              phase ? number("phi", phase.mapped()) : 0,
                              given.units.of_state(four_numbers("near", options.near))});
  }
  const zeros::Effort patience = effort(options);
  const WordOrbits list = [&] {
    const Interruptible scope;
    const Progress progress("searching for orbits ...");
    return find_word_orbits(search);
  }();
  print_result(list, given.file, given.json, given.units,
               options.all ? report::orbits::InFull::all : report::orbits::InFull::admissible);
  if (list.interrupted) {
    return exit_interrupted;
  }
  const bool decided = std::all_of(list.orbits.begin(), list.orbits.end(), is_decided);
  const bool answered = list.searched ? list.complete() : !list.orbits.empty();
  return decided && answered ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
