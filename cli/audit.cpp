// stickslip audit: every statement of the paper.
#include <fmt/format.h>

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

std::vector<ExampleOrbits> example_orbits() {
  std::vector<ExampleOrbits> all;
  for (const Example& example : printed_examples()) {
    all.push_back(orbits_of(example));
  }
  return all;
}

}  // namespace

ExitCode run(const AuditOptions& options) {
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

}  // namespace stickslip::cli
