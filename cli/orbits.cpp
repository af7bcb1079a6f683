// stickslip orbits: all periodic orbits of a family.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
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

constexpr int default_digits = 20;
constexpr int most_digits = 2000;

struct Options {
  std::string family;
  TypedParameters parameters;
  std::string file;
  std::string example;
  std::string digits;
  std::string jobs;
  std::string plot;
  bool with_plot = false;
  std::string out;
  bool with_out = false;
  bool json = false;
};

constexpr const char* details =
    "Searches the whole closed domain of the family and lists every orbit, each proved to\n"
    "exist, with every condition decided along the whole motion; what could not be decided\n"
    "is listed too.\n\n"
    "A number is a decimal or a fraction and is taken exactly: 0.1607, 2.5e-3, 1/3. With\n"
    "0.5+-1e-4 for some parameters, each orbit is proved for all values in the box.\n\n"
    "symmetric     ur and phi are results and are not given.\n"
    "overshooting  exactly one of --phi and --ur is given; the other is a result.\n"
    "nonsticking   phi is a result; without --ur the largest admissible one is, ur_max,\n"
    "              and \"admissible\" speaks of all other conditions.\n\n"
    "Exit code: 0 the list is complete and everything in it is decided, also if no orbit\n"
    "is admissible; 2 something is undecided or unresolved; 130 after Ctrl-C, which ends\n"
    "the search: what it has found is still printed and written, marked as interrupted.";

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

ExitCode run(const Options& options) {
  if (options.family.empty()) {
    throw UsageError("a family of orbits is missing: symmetric, overshooting or nonsticking");
  }
  const OrbitQuestion asked =
      question(family_named(options.family), options.parameters, options.file, options.example,
               whole_number("digits", options.digits, most_digits, default_digits));
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

}  // namespace

void add_orbits(CLI::App& program, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("orbits", "List all periodic orbits of a family, proved");
  command->footer(details);
  command->add_option("FAMILY", options->family, "symmetric, overshooting or nonsticking")->type_name("");
  add_parameters(*command, options->parameters);
  command->add_option("--example", options->example, "Take the data of the paper's example S, O or P")
      ->type_name("NAME");
  command
      ->add_option("--params", options->file,
                   "Take parameters from a TOML file with lines chi = 0.5;\noptions above replace them")
      ->type_name("FILE");
  command
      ->add_option("--digits", options->digits,
                   fmt::format("Significant digits of each value: {} by default, {} at most", default_digits,
                               most_digits))
      ->type_name("N");
  add_jobs(*command, options->jobs);
  command->add_flag("--json", options->json, "Print the list as JSON");
  CLI::Option* plot = command->add_option("--plot", options->plot,
                                          "Draw the admissible orbits, or all if none is, into FILE.svg or\n"
                                          "FILE.pdf: phase portraits and time histories");
  plot->type_name("FILE");
  CLI::Option* out =
      command->add_option("--out", options->out,
                          "Also write a report into DIR: index.html, orbits.pdf where there is\n"
                          "TeX, orbits.tex and orbits.json. DIR is created if only its last\n"
                          "part is missing");
  out->type_name("DIR");
  command->callback([options, plot, out, &action] {
    options->with_plot = plot->count() > 0;
    options->with_out = out->count() > 0;
    action = [options] { return run(*options); };
  });
}

}  // namespace stickslip::cli
