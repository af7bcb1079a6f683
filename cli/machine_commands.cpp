// The commands about motions, of a machine in tables.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/machine_answers.hpp"
#include "core/interruption.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

namespace {

// What texts, tables and pictures are made of.
template <class Result>
decltype(auto) seen(const Result& result) {
  if constexpr (requires { report::machines::told(result); }) {
    return report::machines::told(result);
  } else {
    return result;
  }
}

template <class Result>
void print_told(const Result& result, bool json) {
  print(json ? report::tools::to_text(report::machines::to_json(result))
             : terminal_report(seen(result), terminal_style()));
}

template <class Options, class Answer>
ExitCode told(const GivenInTables& given, const Options& o, const char * doing, const Answer& answer_to) {
  const Jobs limit = jobs(o.jobs);
  require_outputs(o);
  const auto result = [&] {
    const Interruptible scope;
    const Progress progress(doing);
    return answer_to(given, o);
  }();
  if constexpr (requires { to_csv(seen(result)); }) {
    if (o.csv) {
      report::tools::write_file(*o.csv, to_csv(seen(result)));
    }
    if (o.plot) {
      draw(*o.plot, plot_script(seen(result), report::tools::plot_format(*o.plot)));
    }
  }
  if (o.out) {
    const Progress progress("making the page ...");
    report::tools::write_files(*o.out, report::machines::pages(result));
  }
  print_told(result, o.json);
  if (o.out) {
    tell(fmt::format("The report is in {}: index.html.", *o.out));
  }
  return exit_of(result);
}

constexpr auto answered = [](const GivenInTables& given, const auto& o) { return answer(given, o); };

template <class Options>
ExitCode steady(const GivenInTables& given, const Options& o) {
  const Jobs limit = jobs(o.jobs);
  const auto result = [&] {
    const Progress progress("looking at steady sliding ...");
    return steady_answer(given, o);
  }();
  print_told(result, o.json);
  return exit_of(result);
}

}  // namespace

ExitCode run_plane(const GivenInTables& given, const AttractorsOptions& o) {
  return told(given, o, "following the starts ...", basins_answer);
}

ExitCode run_box(const GivenInTables& given, const BranchOptions& o) {
  return told(given, o, "proving parts of the box ...", box_answer);
}

ExitCode run_set(const GivenInTables& given, const SimulateOptions& o) {
  const report::machines::SetMotion result = [&] {
    const Interruptible scope;
    const Progress progress("following the set ...");
    return set_answer(given, o);
  }();
  print_told(result, o.json);
  return result.interrupted ? exit_interrupted : result.open.empty() ? exit_decided : exit_undecided;
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
  require_outputs(o);
  std::optional<report::tools::PendingFile> file;
  if (o.csv) {
    file.emplace(*o.csv);
  }
  if (file) {
    file->append(report::machines::csv_names({{given->read.machine}, {given->file, given->read.in_SI}}));
  }
  const auto take = [&](const SampleOfMachine& sample) { file->append(report::machines::csv_line(sample)); };
  const report::machines::Motion result = [&] {
    const Interruptible scope;
    const Progress progress("simulating ...");
    return answer(
        *given, o, [](double) { return !interrupted(); },
        file ? std::function<void(const SampleOfMachine&)>(take) : nullptr);
  }();
  if (file) {
    file->complete();
    file->take_place();
  }
  print_told(result, o.json);
  return result.record.interrupted ? exit_interrupted : exit_decided;
}

}  // namespace stickslip::cli
