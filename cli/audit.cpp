// stickslip audit: every statement of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "numeric/example_orbits.hpp"
#include "proofs/mutants.hpp"
#include "proofs/paper.hpp"
#include "report/files.hpp"
#include "report/json.hpp"
#include "report/mutants.hpp"
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

std::optional<proofs::Gate> gate_of(const AuditOptions& options) {
  if (!options.mutants) {
    return std::nullopt;
  }
  Progress line("making wrong statements ...");
  return proofs::mutant_gate(proofs::paper(), {}, {options.seed, options.one_in},
                             [&line](const std::string& id, std::size_t done, std::size_t all) {
                               line.show(fmt::format("wrong statements of {} ({} of {})", id, done, all));
                             });
}

// A wrong statement is proved.
bool any_survived(const std::optional<proofs::Gate>& gate) {
  return gate && std::ranges::any_of(gate->mutants, [](const proofs::Mutant& mutant) {
           return mutant.fate == proofs::Fate::survived;
         });
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
  const std::optional<proofs::Gate> gate = gate_of(options);
  report::Report made;
  if (options.with_out) {
    const Progress progress("making the pages ...");
    made = report::pages(audit, examples, gate);
    report::write_files(options.out, made.files);
  }
  const std::string command = options.mutants ? "stickslip audit --mutants" : "stickslip audit";
  print(options.json ? report::to_text(report::to_json(audit, command, examples, gate))
                     : report::terminal_report(audit, terminal_style()) +
                           (gate ? "\n" + report::terminal_mutants(*gate, terminal_style()) : ""));
  if (options.with_out) {
    tell(report_line(options.out, "audit", made));
  }
  if (any_survived(gate)) {
    return exit_refuted;
  }
  return report::all_decided(audit) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
