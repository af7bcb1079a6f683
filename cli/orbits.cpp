// stickslip orbits: all periodic orbits of a family.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/commands.hpp"
#include "cli/machine_file.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "cli/output.hpp"
#include "core/interruption.hpp"
#include "numeric/words/word.hpp"
#include "report/audit/pages.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/orbits_plot.hpp"
#include "report/orbits/pictures.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"

namespace stickslip::cli {

using namespace numeric;

namespace {

OrbitList search(const OrbitQuestion& question) {
  const Interruptible scope;
  const Progress progress("searching for orbits ...");
  return list_orbits(question);
}

void draw(const OrbitList& list, const std::string& file) {
  const std::string script = report::orbits::plot_script(list, report::tools::plot_format(file));
  if (script.empty()) {
    tell(fmt::format("There is no orbit to draw: {} is not written.", file));
    return;
  }
  report::tools::write_plot(file, script);
}

}  // namespace

ExitCode run(const OrbitsOptions& options, const proofs::methods::Paper& paper) {
  if (options.family.empty()) {
    throw UsageError("a family of orbits is missing: " + families::names_of_families());
  }
  if (words::looks_like_word(options.family)) {
    return run_word(options, paper);
  }
  if (!options.period.empty() || options.with_near) {
    throw UsageError(
        fmt::format("--period and --near are for words of phases, not for the family '{}'", options.family));
  }
  const ParameterFile file =
      read_parameters(options.file, options.parameters, options.example, FrictionAtRest::optional);
  const report::orbits::Units units = units_of(options.units, file, options.json);
  const Family& family = family_named(options.family);
  if (file.machine && file.machine->ur && !family.why_no_ur.empty()) {
    throw UsageError(
        fmt::format("{}: leave the friction at rest out, for {}", options.file, family.why_no_ur));
  }
  const OrbitQuestion asked = question(
      paper, family, options.parameters, file.parameters, options.example,
      whole_number("digits", options.digits, OrbitsOptions::most_digits, OrbitsOptions::default_digits));
  const Jobs limit = jobs(options.jobs);
  if (options.with_plot) {
    (void)report::tools::plot_format(options.plot);
    report::tools::require_plot(options.plot);
  }
  if (options.with_out) {
    report::tools::require_writable(options.out);
    report::orbits::require_page_tools(false);
  }
  const OrbitList list = search(asked);
  if (options.with_plot) {
    draw(list, options.plot);
  }
  report::audit::Report made;
  if (options.with_out) {
    const Progress progress("making the pages ...");
    made = report::audit::pages(list);
    report::tools::write_files(options.out, made.files);
  }
  print(options.json ? report::tools::to_text(with_machine(report::orbits::to_json(list), file))
                     : machine_report(file) + report::orbits::terminal_report(list, terminal_style(), units));
  if (options.with_out) {
    tell(report_line(options.out, "orbits", made));
  }
  if (std::count(list.remarks.begin(), list.remarks.end(), Remark::interrupted) > 0) {
    return exit_interrupted;
  }
  return all_decided(list) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
