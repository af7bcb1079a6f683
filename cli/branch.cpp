// stickslip branch: orbits over an interval of one parameter, and every change.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/machine_file.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "cli/output.hpp"
#include "core/interruption.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/branches.hpp"
#include "report/tools/files.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::branches;

namespace {

bool is_decided(const BranchList& list) {
  bool proved = true;
  for (const Branch& branch : list.branches) {
    for (const Change& change : branch.changes) {
      proved = proved && (change.verdict.truth == Truth::proved || change.kind == ChangeKind::resonance);
    }
  }
  return proved && list.resolved();
}

}  // namespace

ExitCode run(const BranchOptions& o, const proofs::methods::Paper& paper) {
  if (o.family.empty()) {
    throw UsageError("a family of orbits is missing: " + families::names_of_families());
  }
  const Family& family = family_named(o.family);
  ParameterFile file = read_parameters(o.file, o.parameters, o.example, FrictionAtRest::optional);
  leave_results_out(file, family, o.parameters);
  const BranchQuestion asked = branch_question(paper, family, o.parameters, file.parameters, o.example, o.at);
  const Jobs limit = jobs(o.jobs);
  if (!o.csv.empty()) {
    report::tools::require_writable_file(o.csv);
  }
  if (!o.plot.empty()) {
    (void)report::tools::plot_format(o.plot);
    report::tools::require_plot(o.plot);
  }
  const BranchList list = [&] {
    const Interruptible scope;
    const Progress progress("following branches ...");
    return list_branches(asked);
  }();
  if (!o.csv.empty()) {
    const std::filesystem::path csv = o.csv;
    report::tools::write_files(csv.has_parent_path() ? csv.parent_path() : ".",
                               {{csv.filename().string(), report::orbits::to_csv(list)}});
  }
  if (!o.plot.empty()) {
    const std::string script = report::orbits::plot_script(list, report::tools::plot_format(o.plot));
    if (script.empty()) {
      tell(fmt::format("There is nothing to draw: {} is not written.", o.plot));
    } else {
      report::tools::write_plot(o.plot, script);
    }
  }
  tell_left_out(file);
  print(o.json ? report::tools::to_text(with_machine(report::orbits::to_json(list), file))
               : machine_report(file) + report::orbits::terminal_report(list, terminal_style()));
  return list.interrupted ? exit_interrupted : is_decided(list) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
