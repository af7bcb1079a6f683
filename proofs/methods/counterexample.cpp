#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/points.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/evaluate.hpp"
#include "proofs/symbols/point.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

// The verdict refuted, with its theorem; undecided where the kernel does not say so.
void refute(Outcome& outcome, Prover& prover, const Scene& scene, const std::vector<Statement>& holding,
            const std::vector<Statement>& failing) {
  const auto open = [&](const std::exception& error) {
    outcome.verdict = Verdict::undecided(fmt::format("no counterexample: {}", error.what()));
  };
  try {
    outcome.theorems = {refutation(prover, scene, holding, failing)};
    outcome.by_kernel = true;
    outcome.verdict.truth = Truth::refuted;
  } catch (const kernel::KernelError& error) {
    open(error);
  } catch (const NoValue& error) {
    open(error);
  }
}

}  // namespace

Witness witness_of(const Statement& statement, const Scene& scene) {
  Replacements values;
  for (const Statement& value : scene.values) {
    values.emplace(value.left.name(), value.right);
  }
  Sample<Ball> here(values, at_point(scene.point));
  const Value<Ball> left = evaluate_beside<Ball>(statement.left, statement.right, here.lookup()),
                    right = evaluate_beside<Ball>(statement.right, statement.left, here.lookup());
  Eigen::Index shown = 0;
  for (Eigen::Index i = left.size() - 1; i >= 0; --i) {
    shown = left(i).overlaps(right(i)) ? shown : i;
  }
  Witness witness{scene.point, {}, left(shown), right(shown)};
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
    refute(outcome, prover, scene, holding, example.false_there);
    if (outcome.verdict.truth == Truth::refuted) {
      Witness witness = witness_of(example.false_there.back(), scene);
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
  if (!vocabulary_here().is_of_model()) {  // symbolic/ knows the oscillator's symbols alone
    for (const Statement& printed : claim.printed) {
      if (const auto refuted = refuted_at_point(prover, claim, printed)) {
        outcome = *refuted;
        return;
      }
    }
    return;
  }
  const WorkingPrecision precision(256);
  Scene scene;
  std::vector<Statement> holding;
  for (const Assumption& assumption : claim.assumptions) {
    holding.push_back(assumption.statement);
    if (is_substitution(assumption)) {
      scene.values.push_back(assumption.statement);
    }
  }
  for (const Statement& equation : std::vector<Statement>(outcome.doubted)) {
    Outcome decision;
    try {
      decide(decision, claim, equation);
    } catch (const GiNaC::pole_error&) {
      continue;  // it divides by zero
    }
    if (decision.verdict.truth != Truth::refuted) {
      continue;
    }
    // There the equation fails; whether what is printed does is for the kernel to say.
    scene.point = decision.verdict.witness->point;
    for (const Statement& printed : claim.printed) {
      Outcome refuted = decision;
      refute(refuted, prover, scene, holding, {printed});
      if (refuted.verdict.truth == Truth::refuted) {
        refuted.route =
            "values with which all that is assumed holds and what is printed does not, in balls; equations "
            "by normal form, motions by their closed form";
        refuted.hypotheses.clear();  // the theorem has none
        refuted.free.clear();
        outcome = refuted;
        return;
      }
      outcome.verdict = Verdict::undecided(
          fmt::format("{} is false at a point at which the assumptions are not known to hold: {}",
                      text(equation), refuted.verdict.reason));
    }
  }
}

}  // namespace stickslip::proofs::methods
