#include <fmt/format.h>

#include "core/error.hpp"
#include "proofs/implications.hpp"
#include "proofs/point.hpp"

namespace stickslip::proofs {
namespace {

// +1, -1 if the statement certainly holds or certainly fails, else 0.
int decided(const Statement& statement, const Ball& left, const Ball& right) {
  const Ball gap = left - right;
  switch (statement.relation) {
    case Relation::equal:
      return gap.is_nonzero() ? -1 : 0;
    case Relation::not_equal:
      return gap.is_nonzero() ? 1 : 0;
    case Relation::less:
    case Relation::less_or_equal:
      return gap.is_negative() ? 1 : gap.is_positive() ? -1 : 0;
    case Relation::greater:
    case Relation::greater_or_equal:
      return gap.is_positive() ? 1 : gap.is_negative() ? -1 : 0;
  }
  return 0;
}

}  // namespace

Proof by_counterexample(Counterexample example) {
  return [example = std::move(example)](Prover&, const Claim& claim) {
    const WorkingPrecision precision(256);
    Replacements replacements;
    for (const Statement& value : example.values) {
      replacements.emplace(value.left.name(), value.right);
    }
    const Lookup<Ball> here = at_point(example.point);
    const auto side = [&](const Term& term) {
      return evaluate<Ball>(substitute(term, replacements), here)(0, 0);
    };
    for (const Statement& statement : example.true_there) {
      if (decided(statement, side(statement.left), side(statement.right)) != 1) {
        throw InternalError(
            fmt::format("claim {}: {} does not hold at the counterexample", claim.id, text(statement)));
      }
    }
    const Statement& failing = example.false_there;
    Outcome outcome;
    outcome.route = "a point where all that is assumed holds and the conclusion does not, in balls";
    const Ball left = side(failing.left);
    const Ball right = side(failing.right);
    outcome.verdict =
        decided(failing, left, right) == -1
            ? Verdict::refuted(Witness{example.point, {}, left, right})
            : Verdict::undecided(fmt::format("{} is not refuted at the counterexample", text(failing)));
    return outcome;
  };
}

}  // namespace stickslip::proofs
