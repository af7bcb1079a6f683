// stickslip orbits: all periodic orbits of a family, or of a word of phases.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/answers/asked.hpp"
#include "cli/answers/machine_answers.hpp"
#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/answer.hpp"
#include "cli/commands/commands.hpp"
#include "numeric/families/family.hpp"
#include "numeric/words/word.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "report/audit/pages.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/page.hpp"

namespace stickslip::cli {

using namespace numeric;
using report::orbits::InFull;

namespace {

// What the search gives, as long as it may go on.
template <class Search>
auto found(const OrbitsOptions& options, const Search& search) {
  const zeros::Effort patience{options.cells, options.time};
  return worked_out("searching for orbits ...", search);
}

// All that is asked for: the picture, the pages, the list.
template <class Question, class List>
void tell_list(const OrbitsOptions& options, const Asked<Question>& asked, const List& list) {
  const report::orbits::Listed listed(list);
  if (options.plot) {
    draw(*options.plot,
         report::orbits::plot_script(listed.list, report::tools::plot_format(*options.plot),
                                     report::tools::PlotShape::wide, std::nullopt, asked.units),
         "no orbit");
  }
  report::audit::Report made;
  if (options.out) {
    const Progress progress("making the pages ...");
    made = report::audit::pages(listed);
    report::tools::write_files(*options.out, made.files);
  }
  print_result(list, asked.file, options.json, asked.units, options.all ? InFull::all : InFull::admissible);
  if (options.out) {
    tell(report_line(*options.out, "orbits", made));
  }
}

// Whether motions of one phase are possible, which has no events that a search could go through.
ExitCode run_pure(motion::PhaseKind kind, const OrbitsOptions& options,
                  const proofs::methods::Examples& examples) {
  if (options.neighbourhood || options.plot || options.out) {
    throw UsageError(fmt::format("--{} is for periodic orbits, not for motions of one phase",
                                 options.neighbourhood ? "neighbourhood"
                                 : options.plot        ? "plot"
                                                       : "out"));
  }
  const auto [file, units, machine] = asked_pure_word(options, examples);
  const Jobs limit = jobs(options.jobs);
  const report::orbits::PureWord word{machine, kind};
  print_result(word, file, options.json, units);
  return exit_of(false, report::orbits::exists(word).truth != Truth::undecided);
}

// One claim for each admissible orbit: that it exists, and, where that is decided, whether it is stable.
std::vector<proofs::methods::Claim> claims_of(const OrbitList& list) {
  using namespace proofs;
  std::vector<methods::Claim> claims;
  for (std::size_t k = 0; k < list.orbits.size(); ++k) {
    if (!is_admissible(list.orbits[k])) {
      continue;
    }
    methods::Claim claim{.id = fmt::format("{}.{}", list.question.family->name, k + 1)};
    claim.kind = methods::Kind::numbers;
    claim.origin = methods::Origin::new_result;
    claim.words = fmt::format("orbit {} of the list exists", k + 1);
    claim.prove = [&list, k](methods::Prover&, const methods::Claim&) {
      methods::Outcome outcome;
      const motion::Motion& motion = list.orbits[k].motion;
      try {
        const orbits::Question question = orbits::question_of(list.question, motion);
        outcome.theorems = {orbits::orbit_theorem(question, motion)};
        outcome.by_kernel = true;
        outcome.verdict = Verdict::proved();
        outcome.theorems.push_back(orbits::stability_theorem(outcome.theorems.front(), question));
      } catch (const kernel::KernelError& error) {
        if (outcome.theorems.empty()) {
          outcome.verdict = Verdict::undecided(error.what());
        }
      }
      return outcome;
    };
    claims.push_back(std::move(claim));
  }
  return claims;
}

void certify(const OrbitList& list, const std::string& directory) {
  const std::vector<proofs::methods::Claim> claims = claims_of(list);
  if (claims.empty()) {
    tell(fmt::format("There is no admissible orbit to certify: {} is not written.", directory));
    return;
  }
  proofs::certificates::Certificates made;
  {
    const Progress progress("writing certificates ...");
    made = proofs::certificates::certificates(claims);
  }
  if (made.certificates.empty()) {
    tell(fmt::format("No orbit has a certificate: {} is not written.", directory));
  } else {
    write_certificates(directory, made);
    tell(fmt::format("Certificates of {} orbits are in {}: make -k -j there has Coq check them.",
                     made.certificates.size(), directory));
  }
  for (const proofs::certificates::Certificate& one : made.certificates) {
    if (one.theorems.size() == 1) {
      tell(fmt::format("{} is certified to exist; whether it is stable is not.", one.claim));
    }
  }
  for (const proofs::certificates::Uncertified& one : made.uncertified) {
    tell(fmt::format("{} has none: {}.", one.claim, one.reason));
  }
}

ExitCode run_family(const OrbitsOptions& options, const proofs::methods::Examples& examples) {
  const auto asked = asked_orbits(options, examples);
  const Jobs limit = jobs(options.jobs);
  require_outputs(options);
  if (!options.certify.empty()) {
    if (asks_for_box(asked.question)) {
      throw UsageError("--certify is for exact parameters, not for a box of them");
    }
    report::tools::require_writable(options.certify);
    require_certificates_only(options.certify);
  }
  const OrbitList list = found(options, [&] { return list_orbits(asked.question); });
  if (!options.certify.empty()) {
    certify(list, options.certify);
  }
  tell_list(options, asked, list);
  return exit_of(std::ranges::count(list.remarks, Remark::interrupted) > 0, all_decided(list));
}

ExitCode run_word(const OrbitsOptions& options, const proofs::methods::Examples& examples) {
  if (!options.certify.empty()) {
    throw UsageError("--certify is for a family, not for a word of phases");
  }
  if (const auto kind = words::kind_of(options.family)) {
    return run_pure(*kind, options, examples);
  }
  const auto asked = asked_word(options, examples);
  const Jobs limit = jobs(options.jobs);
  require_outputs(options);
  const attractors::WordOrbits list = found(options, [&] { return find_word_orbits(asked.question); });
  tell_list(options, asked, list);
  const bool answered = list.searched ? list.complete() : !list.orbits.empty();
  return exit_of(list.interrupted, answered && std::ranges::all_of(list.orbits, is_decided));
}

}  // namespace

ExitCode run(const OrbitsOptions& options, const proofs::methods::Examples& examples) {
  if (options.family.empty()) {
    throw UsageError("a family of orbits is missing: " + families::names_of_families());
  }
  if (const auto done = run_in_tables(options)) {
    return *done;
  }
  require_no_basin(options.basin);
  return words::looks_like_word(options.family) ? run_word(options, examples) : run_family(options, examples);
}

}  // namespace stickslip::cli
