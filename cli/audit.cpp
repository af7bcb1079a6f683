// stickslip audit: every statement of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "proofs/checks/mutants.hpp"
#include "proofs/methods/example_orbits.hpp"
#include "report/audit/json.hpp"
#include "report/audit/mutants.hpp"
#include "report/audit/pages.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/pictures.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

using namespace proofs::methods;

namespace {

std::vector<ExampleOrbits> example_orbits(const Paper& paper) {
  std::vector<ExampleOrbits> all;
  for (const Example& example : paper.examples) {
    all.push_back(orbits_of(example));
  }
  return all;
}

std::optional<proofs::checks::Gate> gate_of(const AuditOptions& options, const Paper& paper) {
  if (!options.mutants) {
    return std::nullopt;
  }
  Progress line("making wrong statements ...");
  return proofs::checks::mutant_gate(
      paper.claims, {}, {options.seed, options.one_in},
      [&line](const std::string& id, std::size_t done, std::size_t all) {
        line.show(fmt::format("wrong statements of {} ({} of {})", id, done, all));
      });
}

// A wrong statement is proved.
bool any_survived(const std::optional<proofs::checks::Gate>& gate) {
  return gate && std::ranges::any_of(gate->mutants, [](const proofs::checks::Mutant& mutant) {
           return mutant.fate == proofs::checks::Fate::survived;
         });
}

}  // namespace

ExitCode run(const AuditOptions& options, const Paper& paper) {
  const Jobs limit = jobs(options.jobs);
  if (options.with_out) {
    report::tools::require_writable(options.out);
    report::orbits::require_page_tools(true);
  }
  const proofs::methods::Audit audit = prove(paper.claims, {});
  const std::vector<ExampleOrbits> examples = example_orbits(paper);
  const std::optional<proofs::checks::Gate> gate = gate_of(options, paper);
  report::audit::Report made;
  if (options.with_out) {
    const Progress progress("making the pages ...");
    made = report::audit::pages(paper, audit, examples, gate);
    report::tools::write_files(options.out, made.files);
  }
  const std::string command = options.mutants ? "stickslip audit --mutants" : "stickslip audit";
  print(options.json ? report::tools::to_text(report::audit::to_json(paper, audit, command, examples, gate))
                     : report::audit::terminal_report(paper, audit, terminal_style()) +
                           (gate ? "\n" + report::audit::terminal_mutants(*gate, terminal_style()) : ""));
  if (options.with_out) {
    tell(report_line(options.out, "audit", made));
  }
  if (any_survived(gate)) {
    return exit_refuted;
  }
  return report::audit::all_decided(audit) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
