// The commands about motions, of a machine in tables.

#include <algorithm>
#include <optional>

#include "cli/answers/machine_answers.hpp"
#include "cli/commands/answer.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sample_lines.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/record_json.hpp"

namespace stickslip::cli {

namespace {

using numeric::motion::StabilityKind;

// Whether all is that was asked.
bool is_answered(const numeric::machines::MachineOrbit& orbit) {
  return orbit.existence.truth == Truth::proved &&
         (orbit.admissible.truth == Truth::refuted ||
          (orbit.stability && orbit.stability->kind != StabilityKind::undecided));
}
bool is_answered(const report::machines::Attractors& result) {
  return std::ranges::all_of(result.attractors, [](const numeric::machines::MachineAttractor& a) {
    return a.kind != numeric::attractors::Kind::periodic || (a.orbit && is_answered(*a.orbit));
  });
}
bool is_answered(const report::machines::Diagram& /*result*/) {
  return true;
}
bool is_answered(const report::machines::Basins& /*result*/) {
  return true;
}
bool is_answered(const report::machines::WordOrbits& result) {
  return !result.orbits.empty() &&
         std::ranges::all_of(result.orbits, [](const auto& orbit) { return is_answered(orbit); });
}
bool is_answered(const report::machines::OverBox& result) {
  return !result.motions.empty() && std::ranges::all_of(result.motions, [](const auto& motion) {
    return std::ranges::all_of(motion.parts, [](const numeric::machines::PartOfBox& part) {
      return part.existence.truth == Truth::proved && numeric::machines::is_decided(part.motions.state);
    });
  });
}
bool is_answered(const report::machines::Branches& result) {
  return !result.branches.empty() &&
         std::ranges::all_of(result.branches, [](const auto& b) { return b.resolved(); });
}
bool is_answered(const numeric::machines::SteadySliding& state) {
  return state.existence.truth == Truth::refuted ||
         (state.existence.truth == Truth::proved && state.stability != StabilityKind::undecided);
}
bool is_answered(const numeric::machines::PlanarBasin& basin) {
  return basin.verdict.truth == Truth::refuted ||
         (basin.verdict.truth == Truth::proved && basin.others.truth == Truth::proved);
}
bool is_answered(const report::machines::Steady& result) {
  return is_answered(result.state) && (!result.basin || is_answered(result.basin->basin));
}
bool is_answered(const report::machines::SteadyBranch& result) {
  return std::ranges::all_of(result.along.samples, [](const auto& s) { return is_answered(s.state); }) &&
         (!result.basins || std::ranges::all_of(result.basins->along.samples,
                                                [](const auto& s) { return is_answered(s.basin); }));
}

template <class Options, class Answer>
ExitCode told(const GivenInTables& given, const Options& o, const char * doing, const Answer& answer_to) {
  const Jobs limit = jobs(o.jobs);
  require_outputs(o);
  const auto result = worked_out(doing, [&] { return answer_to(given, o); });
  using report::orbits::to_csv;
  if constexpr (requires { to_csv(result); }) {
    write_table_and_picture(o, result);
  }
  write_page(
      o, [&] { return report::machines::pages(result); }, [&] { print_result(result, {}, o.json); });
  return exit_of(result.interrupted, is_answered(result));
}

constexpr auto answered = [](const GivenInTables& given, const auto& o) { return answer(given, o); };

template <class Options>
ExitCode steady(const GivenInTables& given, const Options& o) {
  const Jobs limit = jobs(o.jobs);
  const auto result = [&] {
    const Progress progress("looking at steady sliding ...");
    return steady_answer(given, o);
  }();
  print_result(result, {}, o.json);
  return exit_of(false, is_answered(result));
}

}  // namespace

ExitCode run_plane(const GivenInTables& given, const AttractorsOptions& o) {
  return told(given, o, "following the starts ...", basins_answer);
}

ExitCode run_box(const GivenInTables& given, const BranchOptions& o) {
  return told(given, o, "proving parts of the box ...", box_answer);
}

ExitCode run_set(const GivenInTables& given, const SimulateOptions& o) {
  const auto result = worked_out("following the set ...", [&] { return set_answer(given, o); });
  print_result(result, {}, o.json);
  return exit_of(result.interrupted, result.open.empty());
}

std::optional<ExitCode> run_in_tables(const AttractorsOptions& o) {
  const auto given = given_in_tables(o);
  if (!given) {
    return std::nullopt;
  }
  constexpr const char * doing = "following the starts ...";
  return o.plane            ? run_plane(*given, o)
         : !o.along.empty() ? told(*given, o, doing, diagram_answer)
                            : told(*given, o, doing, answered);
}

std::optional<ExitCode> run_in_tables(const OrbitsOptions& o) {
  const auto given = given_in_tables(o);
  if (given && is_steady(o.family)) {
    return steady(*given, o);
  }
  return given ? std::optional(told(*given, o, "searching for orbits ...", answered)) : std::nullopt;
}

std::optional<ExitCode> run_in_tables(const BranchOptions& o) {
  const auto given = given_in_tables(o);
  if (given && is_steady(o.family)) {
    return steady(*given, o);
  }
  if (given && o.along.size() > 1) {
    return run_box(*given, o);
  }
  return given ? std::optional(told(*given, o, "following branches ...", answered)) : std::nullopt;
}

std::optional<ExitCode> run_in_tables(const SimulateOptions& o) {
  const auto given = given_in_tables(o);
  if (!given) {
    return std::nullopt;
  }
  if (o.set) {
    return run_set(*given, o);
  }
  require_places(o);
  SampleLines lines(
      o, report::orbits::csv_names(report::machines::coordinates_of({given->machine, given->origin.in_SI})));
  const auto take = [&](const SampleOfMachine& sample) { lines.add(report::orbits::csv_line(sample)); };
  const report::machines::Motion result = worked_out("simulating ...", [&] {
    return answer(
        *given, o, [](double) { return !interrupted(); },
        lines.wanted() ? std::function<void(const SampleOfMachine&)>(take) : nullptr);
  });
  lines.complete();
  lines.take_place();
  if (!are_for_output(o)) {
    print_result(result, {}, o.json);
  }
  return exit_of(result.record.interrupted, true);
}

}  // namespace stickslip::cli
