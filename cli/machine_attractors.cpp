// stickslip attractors of a machine in tables.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/machine_tables.hpp"
#include "cli/numbers.hpp"
#include "core/interruption.hpp"
#include "report/orbits/machine_attractors.hpp"

namespace stickslip::cli {

using namespace numeric::machines;

namespace {

void refuse_others(const AttractorsOptions& o) {
  const std::string& file = o.file.name;
  if (!o.parameters.empty() || !o.example.empty()) {
    throw UsageError(fmt::format("{} is a machine in tables: its data stand in it alone", file));
  }
  for (const auto& [name, given] :
       {std::pair("--along", !o.along.empty()), std::pair("--values", o.values.has_value()),
        std::pair("--plane", o.plane.has_value()), std::pair("--pixels", o.pixels.has_value()),
        std::pair("--through", o.through.has_value()), std::pair("--csv", o.csv.has_value()),
        std::pair("--plot", o.plot.has_value()), std::pair("--out", o.out.has_value()),
        std::pair("--json", o.json), std::pair("--units", o.si)}) {
    if (given) {
      throw UsageError(fmt::format("{} does not go with a machine in tables, {}", name, file));
    }
  }
}

bool is_decided(const MachineAttractor& a) {
  return a.kind != numeric::attractors::Kind::periodic ||
         (a.orbit && a.orbit->existence.truth == Truth::proved &&
          (a.orbit->admissible.truth == Truth::refuted ||
           (a.orbit->stability && a.orbit->stability->kind != numeric::motion::StabilityKind::undecided)));
}

}  // namespace

std::optional<ExitCode> run_in_tables(const AttractorsOptions& options) {
  if (options.file.values || options.file.empty()) {
    return std::nullopt;
  }
  const auto given = machine_in_tables(report::tools::read_file(options.file.name), options.file.name);
  if (!given) {
    return std::nullopt;
  }
  refuse_others(options);
  using Options = AttractorsOptions;
  MachineStarts question{given->machine, options.starts.value_or(Options::default_starts),
                         static_cast<std::uint64_t>(options.seed.value_or(1)),
                         options.most_periods.value_or(Options::default_most_periods),
                         options.digits.value_or(OrbitsOptions::default_digits)};
  const Jobs limit = jobs(options.jobs);
  const MachineAttractors list = [&] {
    const Interruptible scope;
    const Progress progress("following the starts ...");
    return find_attractors(question);
  }();
  print(report::orbits::terminal_report(list, terminal_style(), given->in_SI));
  if (list.interrupted) {
    return exit_interrupted;
  }
  return std::all_of(list.attractors.begin(), list.attractors.end(), is_decided) ? exit_decided
                                                                                 : exit_undecided;
}

}  // namespace stickslip::cli
