// stickslip orbits: all periodic orbits of a family.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "cli/output.hpp"
#include "core/interruption.hpp"
#include "report/files.hpp"
#include "report/json.hpp"
#include "report/orbits.hpp"
#include "report/orbits_plot.hpp"
#include "report/pages.hpp"
#include "report/pictures.hpp"

namespace stickslip::cli {
namespace {

OrbitList search(const OrbitQuestion& question) {
  const Interruptible scope;
  const Progress progress("searching for orbits ...");
  return list_orbits(question);
}

void draw(const OrbitList& list, const std::string& file) {
  const std::string script = report::plot_script(list, report::plot_format(file));
  if (script.empty()) {
    tell(fmt::format("There is no orbit to draw: {} is not written.", file));
    return;
  }
  report::write_plot(file, script);
}

}  // namespace

ExitCode run(const OrbitsOptions& options) {
  if (options.family.empty()) {
    throw UsageError("a family of orbits is missing: symmetric, overshooting or nonsticking");
  }
  const OrbitQuestion asked = question(
      family_named(options.family), options.parameters, options.file, options.example,
      whole_number("digits", options.digits, OrbitsOptions::most_digits, OrbitsOptions::default_digits));
  const Jobs limit = jobs(options.jobs);
  if (options.with_plot) {
    (void)report::plot_format(options.plot);
    report::require_plot(options.plot);
  }
  if (options.with_out) {
    report::require_writable(options.out);
    report::require_page_tools(false);
  }
  const OrbitList list = search(asked);
  if (options.with_plot) {
    draw(list, options.plot);
  }
  report::Report made;
  if (options.with_out) {
    const Progress progress("making the pages ...");
    made = report::pages(list);
    report::write_files(options.out, made.files);
  }
  print(options.json ? report::to_text(report::to_json(list))
                     : report::terminal_report(list, terminal_style()));
  if (options.with_out) {
    tell(report_line(options.out, "orbits", made));
  }
  if (std::count(list.remarks.begin(), list.remarks.end(), Remark::interrupted) > 0) {
    return exit_interrupted;
  }
  return all_decided(list) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
