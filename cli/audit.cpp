// stickslip audit: every statement of the paper.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "numeric/example_orbits.hpp"
#include "proofs/paper.hpp"
#include "report/files.hpp"
#include "report/json.hpp"
#include "report/pages.hpp"
#include "report/pictures.hpp"
#include "report/summary.hpp"

namespace stickslip::cli {
namespace {

struct Options {
  std::string out;
  std::string jobs;
  bool with_out = false;
  bool json = false;
};

std::vector<ExampleOrbits> example_orbits() {
  std::vector<ExampleOrbits> all;
  for (const Example& example : printed_examples()) {
    all.push_back(orbits_of(example));
  }
  return all;
}

ExitCode run(const Options& options) {
  const Jobs limit = jobs(options.jobs);
  if (options.with_out) {
    report::require_writable(options.out);
    report::require_page_tools(true);
  }
  const proofs::Audit audit = prove(proofs::paper(), {});
  const std::vector<ExampleOrbits> examples = example_orbits();
  report::Report made;
  if (options.with_out) {
    const Progress progress("making the pages ...");
    made = report::pages(audit, examples);
    report::write_files(options.out, made.files);
  }
  print(options.json ? report::to_text(report::to_json(audit, "stickslip audit", examples))
                     : report::terminal_report(audit, terminal_style()));
  if (options.with_out) {
    tell(report_line(options.out, "audit", made));
  }
  return report::all_decided(audit) ? exit_decided : exit_undecided;
}

}  // namespace

void add_audit(CLI::App& program, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("audit", "Examine every statement of the paper and report");
  command->footer(
      "Prints a table of all statements with their status, then the findings with their\n"
      "reasons, then the printed numbers beside the proved ones.\n\n"
      "Exit code: 0 everything is decided, also if the paper has misprints;\n"
      "2 something is undecided.");
  CLI::Option* out = command->add_option("--out", options->out,
                                         "Also write the report into DIR: pages for a browser that begin\n"
                                         "with index.html, audit.pdf where there is TeX, audit.tex and\n"
                                         "audit.json. DIR is created if only its last part is missing");
  out->type_name("DIR");
  add_jobs(*command, options->jobs);
  command->add_flag("--json", options->json, "Print the results as JSON instead of the table");
  command->callback([options, out, &action] {
    options->with_out = out->count() > 0;
    action = [options] { return run(*options); };
  });
}

}  // namespace stickslip::cli
