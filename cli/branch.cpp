// stickslip branch: orbits over an interval of one parameter, and every change.
#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "core/decimal.hpp"
#include "core/interruption.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::branches;

namespace {

// What is asked, and the file with what does not count left out.
struct Asked {
  ParameterFile file;
  BranchQuestion question;
};

Along along_of(TypedParameters typed) {
  return along_interval(typed);
}

// The file, of a machine in SI units as it is at the value that `at` says or in the middle. Ranges in it are
// as if they were typed.
ParameterFile file_of(const BranchOptions& o, TypedParameters& typed, FrictionAtRest at_rest) {
  ParameterFile file = read_parameters(o.file, typed, o.example, at_rest, [&](TypedParameters machine) {
    for (const auto& [name, text] : machine) {
      if (typed.contains(name)) {
        continue;
      }
      const auto [from, to] = interval(name, text);
      if (from != to) {
        typed[name] = to_string(from) + ".." + to_string(to);
      }
    }
    const Along along = along_of(typed);
    if (is_in_SI(along.parameter)) {
      machine[along.parameter] = to_string(value_at(along, o.at));
    }
    return machine;
  });
  std::erase_if(file.parameters, [&](const auto& one) {
    const bool is_range = one.second.find("..") != std::string::npos;
    if (is_range) {
      typed.insert(one);
    }
    return is_range;
  });
  const Along along = along_of(typed);
  (void)units_of(o.units, file, false);
  if (!o.units.empty() && !is_in_SI(along.parameter)) {
    throw UsageError(
        fmt::format("--units si goes with --along a value of the machine, not with {}", along.parameter));
  }
  return file;
}

// Along a value of a machine in SI units: the path of its data. The list says all of the machine.
Asked along_machine(Asked asked) {
  BranchQuestion& q = asked.question;
  if (asked.file.machine && is_in_SI(q.parameter)) {
    q.machine = machine_between(asked.file, q.parameter, q.from, q.to);
    q.machine_file = asked.file.name;
    if (q.orbits.phi) {
      q.machine->phi = q.orbits.phi->middle;
    }
    asked.file.machine.reset();
  }
  return asked;
}

Asked asked_of_family(const BranchOptions& o, const proofs::methods::Paper& paper) {
  const Family& family = family_named(o.family);
  if (!o.period.empty()) {
    throw UsageError(fmt::format("--period is for words of phases, not for the family '{}'", o.family));
  }
  if (o.all || !o.orbit.empty() || !o.near.empty()) {
    throw UsageError(
        fmt::format("--all, --orbit and --near are for words of phases, not for the family '{}', of which "
                    "all branches are "
                    "followed",
                    o.family));
  }
  TypedParameters typed = with_along(o.parameters, o.along);
  Asked asked{file_of(o, typed, FrictionAtRest::optional), {}};
  leave_results_out(asked.file, family, typed);
  asked.question = branch_question(paper, family, typed, asked.file.parameters, o.example, o.at);
  return along_machine(std::move(asked));
}

Asked asked_of_word(const BranchOptions& o, const proofs::methods::Paper& paper) {
  const words::Word word = words::Word::parse(o.family);
  const int periods = whole_number("period", o.period, OrbitsOptions::most_periods_of_word, 1);
  TypedParameters typed = with_along(o.parameters, o.along);
  Asked asked{file_of(o, typed, FrictionAtRest::needed), {}};
  leave_out(asked.file, "phi", "the load is cos(omega t), and where in it an orbit begins is a result");
  Followed followed{o.all, o.orbit, {}};
  if (!o.near.empty()) {
    followed.near = units_of(o.units, asked.file, false).of_state(four_numbers("near", o.near));
  }
  asked.question =
      word_branch_question(paper, word, periods, typed, asked.file.parameters, o.example, o.at, followed);
  return along_machine(std::move(asked));
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
  require_outputs(o);
  const auto [file, list] = [&] {
    const Interruptible scope;
    const Progress progress("following branches ...");
    const Asked asked =
        words::looks_like_word(o.family) ? asked_of_word(o, paper) : asked_of_family(o, paper);
    return std::pair(asked.file, list_branches(asked.question));
  }();
  write_outputs(o, list, file);
  return list.interrupted ? exit_interrupted : is_decided(list) ? exit_decided : exit_undecided;
}

}  // namespace stickslip::cli
