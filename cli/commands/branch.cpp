// stickslip branch: orbits over an interval of one parameter, and every change.

#include <fmt/format.h>

#include "cli/answers/asked.hpp"
#include "cli/answers/machine_answers.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/answer.hpp"
#include "cli/commands/commands.hpp"
#include "core/interruption.hpp"
#include "numeric/families/family.hpp"

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

ExitCode run(const BranchOptions& o, const proofs::methods::Examples& examples) {
  if (o.family.empty()) {
    throw UsageError("a family of orbits is missing: " + families::names_of_families());
  }
  if (const auto done = run_in_tables(o)) {
    return *done;
  }
  require_no_basin(o.basin);
  if (o.without_gaps) {
    throw UsageError(
        "--without-gaps is for words of a machine in tables: branches of the paper's oscillator have no "
        "gaps");
  }
  if (o.along.size() > 1) {
    const auto [given, rest] = box_in_tables(o, examples);
    return run_box(given, rest);
  }
  const Jobs limit = jobs(o.jobs);
  require_outputs(o);
  const auto [file, list] = [&] {
    const Interruptible scope;
    Progress progress("following branches ...");
    auto asked = asked_branch(o, examples);
    asked.question.found = [&, count = 0](const Branch& branch) mutable {
      progress.show(fmt::format("following branches: {} so far, the last from {} to {} ...", ++count,
                                to_string(branch.first.at, 6), to_string(branch.last.at, 6)));
    };
    BranchList followed = list_branches(asked.question);
    followed.question.found = {};
    return std::pair(asked.file, std::move(followed));
  }();
  write_outputs(o, list, file);
  return exit_of(list.interrupted, is_decided(list));
}

}  // namespace stickslip::cli
