#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

Witness witness_of(const Statement& statement, const Scene& scene) {
  Replacements values;
  for (const Statement& value : scene.values) {
    values.emplace(value.left.name(), value.right);
  }
  const Lookup<Ball> there = at_point(scene.point);
  Sample<Ball> here(values, [&](const std::string& name) {
    try {
      return there(name);
    } catch (
        const InternalError&) {  // what the scene does not name makes no difference: 0 < omega1 < 1 < omega2
      return name == "omega1" ? Ball(1) / Ball(2) : Ball(2);
    }
  });
  const auto [left, right] = both_sides<Ball>(statement, here.lookup());
  Eigen::Index shown = 0;
  for (Eigen::Index i = left.size() - 1; i >= 0; --i) {
    shown = left(i).overlaps(right(i)) ? shown : i;
  }
  Witness witness{scene.point, {}, left(shown), right(shown)};
  std::set<std::string> spoken_of = names_in(statement.left);
  spoken_of.merge(names_in(statement.right));
  for (const Statement& value : scene.values) {
    if (const std::string& name = value.left.name(); spoken_of.contains(name)) {
      witness.values.push_back(fmt::format("${} = {}$", name, to_string(here(name), 10)));
    }
  }
  if (left.size() > 1) {
    witness.component = fmt::format("({},{})", shown % left.rows() + 1, shown / left.rows() + 1);
  }
  return witness;
}

Proof by_counterexample(Counterexample example) {
  return [example = std::move(example)](Prover& prover, const Claim&) {
    const WorkingPrecision precision(256);
    Outcome outcome;
    std::vector<Statement> holding = example.values;
    holding.insert(holding.end(), example.true_there.begin(), example.true_there.end());
    const Scene scene{example.point, example.values};
    const auto failure =
        failure_of([&] { outcome.theorems = {refutation(prover, scene, holding, example.false_there)}; });
    if (failure) {
      outcome.verdict = Verdict::undecided(fmt::format("no counterexample: {}", *failure));
    } else {
      outcome.by_kernel = true;
      Witness witness = witness_of(example.false_there.back(), scene);
      witness.values.clear();  // the claim states them
      if (example.false_there.size() > 1) {
        witness.left_name += " of the last";
      }
      outcome.verdict = Verdict::refuted(witness);
    }
    std::vector<std::string> failed;
    for (const Statement& failing : example.false_there) {
      failed.push_back("$" + text(failing) + "$");
    }
    outcome.route = fmt::format(
        "a point where all that is assumed holds and the conclusion does not; what fails there: {}",
        fmt::join(failed, "; "));
    return outcome;
  };
}

void look_for_witness(Outcome& outcome, Prover& prover, const Claim& claim) {
  if (outcome.verdict.truth != Truth::undecided) {
    return;
  }
  const bool by_values = !outcome.doubted.empty() && std::ranges::all_of(claim.assumptions, is_substitution);
  const bool as_printed = outcome.doubted.empty();
  for (const Statement& doubted : as_printed ? claim.printed : outcome.doubted) {
    for (const Statement& printed : as_printed ? std::vector{doubted} : claim.printed) {
      if (auto refuted = refuted_at_point(prover, claim, printed, {}, doubted)) {
        if (by_values) {
          refuted->decided = {{doubted}};
        }
        outcome = *std::move(refuted);
        return;
      }
    }
  }
}

}  // namespace stickslip::proofs::methods
