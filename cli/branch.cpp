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
#include "report/orbits/branches_page.hpp"
#include "report/tools/files.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::branches;

namespace {

// What is asked, and the file with what does not count left out.
struct Asked {
  ParameterFile file;
  BranchQuestion question;
};

Asked asked_of_family(const BranchOptions& o, const proofs::methods::Paper& paper) {
  const Family& family = family_named(o.family);
  if (!o.period.empty()) {
    throw UsageError(fmt::format("--period is for words of phases, not for the family '{}'", o.family));
  }
  Asked asked{read_parameters(o.file, o.parameters, o.example, FrictionAtRest::optional), {}};
  leave_results_out(asked.file, family, o.parameters);
  asked.question = branch_question(paper, family, o.parameters, asked.file.parameters, o.example, o.at);
  return asked;
}

Asked asked_of_word(const BranchOptions& o, const proofs::methods::Paper& paper) {
  const words::Word word = words::Word::parse(o.family);
  const int periods = whole_number("period", o.period, OrbitsOptions::most_periods_of_word, 1);
  Asked asked{read_parameters(o.file, o.parameters, o.example, FrictionAtRest::needed), {}};
  leave_out(asked.file, "phi", "the load is cos(omega t), and where in it an orbit begins is a result");
  asked.question =
      word_branch_question(paper, word, periods, o.parameters, asked.file.parameters, o.example, o.at);
  return asked;
}

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
  const Jobs limit = jobs(o.jobs);
  if (!o.csv.empty()) {
    report::tools::require_writable_file(o.csv);
  }
  if (!o.plot.empty()) {
    (void)report::tools::plot_format(o.plot);
    report::tools::require_plot(o.plot);
  }
  if (o.with_out) {
    require_page(o.out);
  }
  const auto [file, list] = [&] {
    const Interruptible scope;
    const Progress progress("following branches ...");
    const Asked asked =
        words::looks_like_word(o.family) ? asked_of_word(o, paper) : asked_of_family(o, paper);
    return std::pair(asked.file, list_branches(asked.question));
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
  if (o.with_out) {
    const Progress progress("making the page ...");
    report::tools::write_files(o.out, report::orbits::pages(list, {file.name, file.machine, {}}));
  }
  tell_left_out(file);
  print(o.json ? report::tools::to_text(with_machine(report::orbits::to_json(list), file))
               : machine_report(file) + report::orbits::terminal_report(list, terminal_style()));
  if (o.with_out) {
    tell(fmt::format("The report is in {}: index.html.", o.out));
  }
  return list.interrupted ? exit_interrupted : is_decided(list) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
