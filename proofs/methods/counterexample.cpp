#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/symbols/point.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

// +1, -1 if the relation between the sides certainly holds or certainly fails, else 0. Balls that are exact
// decide equality too.
int decided(Relation relation, const Ball& left, const Ball& right) {
  const Ball gap = left - right;
  const bool same = gap.is_exact() && !gap.is_nonzero();
  const auto sign = [same](bool yes, bool no) { return yes ? 1 : no || same ? -1 : 0; };
  switch (relation) {
    case Relation::equal:
      return same ? 1 : gap.is_nonzero() ? -1 : 0;
    case Relation::not_equal:
      return sign(gap.is_nonzero(), false);
    case Relation::less:
      return sign(gap.is_negative(), gap.is_positive());
    case Relation::greater:
      return sign(gap.is_positive(), gap.is_negative());
    case Relation::less_or_equal:
      return gap.is_positive() ? -1 : gap.is_negative() || same ? 1 : 0;
    case Relation::greater_or_equal:
      return gap.is_negative() ? -1 : gap.is_positive() || same ? 1 : 0;
  }
  return 0;
}

// The scalars at the point, with the values given in terms of them.
struct Place {
  Lookup<Ball> point;
  Replacements values;

  [[nodiscard]] Value<Ball> operator()(const Term& term) const {
    return evaluate<Ball>(term, [this](const std::string& name) {
      const auto found = values.find(name);
      return found == values.end() ? point(name) : (*this)(found->second)(0, 0);
    });
  }
};

struct Sides {
  int decided = 0;  // of all entries: 1 if each holds, -1 if one fails
  Ball left, right;
};

Sides sides_of(const Statement& statement, const Place& here) {
  const Value<Ball> left = here(statement.left), right = here(statement.right);
  Sides result{1, left(0, 0), right(0, 0)};
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    const int entry = decided(statement.relation, left(i), right(i));
    if (entry == -1) {
      return {-1, left(i), right(i)};
    }
    result.decided = std::min(result.decided, entry);
  }
  return result;
}

// Identities that hold once the values are put in, the point left open.
void require_identities(Outcome& outcome, const Claim& claim, const Counterexample& example) {
  Claim reading = claim;
  reading.assumptions.clear();
  for (const Statement& value : example.values) {
    reading.assumptions.push_back({"value", value});
  }
  for (const Statement& statement : example.true_identically) {
    decide(outcome, reading, statement);
    if (outcome.verdict.truth != Truth::proved) {
      throw InternalError(
          fmt::format("claim {}: {} is no identity at the counterexample", claim.id, text(statement)));
    }
  }
  outcome.hypotheses.clear();
  outcome.assumed.clear();
}

}  // namespace

Proof by_counterexample(Counterexample example) {
  return [example = std::move(example)](Prover&, const Claim& claim) {
    const WorkingPrecision precision(256);
    Outcome outcome;
    require_identities(outcome, claim, example);
    outcome.route = "a point where all that is assumed holds and the conclusion does not, in balls";
    Place here{at_point(example.point), {}};
    for (const Statement& value : example.values) {
      here.values.emplace(value.left.name(), value.right);
    }
    for (const Statement& statement : example.true_there) {
      if (sides_of(statement, here).decided != 1) {
        throw InternalError(
            fmt::format("claim {}: {} does not hold at the counterexample", claim.id, text(statement)));
      }
    }
    std::vector<std::string> failed;
    for (const Statement& failing : example.false_there) {
      const Sides sides = sides_of(failing, here);
      if (sides.decided != -1) {
        outcome.verdict =
            Verdict::undecided(fmt::format("{} is not refuted at the counterexample", text(failing)));
        return outcome;
      }
      outcome.verdict = Verdict::refuted(Witness{example.point, {}, sides.left, sides.right});
      failed.push_back("$" + text(failing) + "$");
    }
    outcome.route += fmt::format("; what fails there: {}", fmt::join(failed, "; "));
    return outcome;
  };
}

namespace {

bool is_phase(const Assumption& assumption) {
  return assumption.statement.during && assumption.statement.left.op() == Op::derivative;
}

// Whether there is a motion as the claim assumes it, wherever it starts: it moves in one phase, whose first
// state is named, for a linear differential equation has a solution from every state.
bool says_where_it_starts(const Claim& claim, const Statement& statement) {
  const auto phases = std::ranges::count_if(claim.assumptions, is_phase);
  const auto phase = std::ranges::find_if(claim.assumptions, is_phase);
  return phases == 1 && statement.relation == Relation::equal && statement.left.op() == Op::function &&
         statement.left.name() == "Z" && is_in_field(statement.right) &&
         equal(statement.left.arguments().front(), phase->statement.during->from);
}

// Whether what is assumed certainly holds, for some motion.
bool holds(const Claim& claim, const Assumption& assumption, const Place& here) {
  const Statement& statement = assumption.statement;
  const auto given =
      is_substitution(assumption) ? here.values.find(statement.left.name()) : here.values.end();
  if (given != here.values.end() && equal(given->second, statement.right)) {
    return true;
  }
  if (says_where_it_starts(claim, statement) ||
      (is_phase(assumption) && std::ranges::count_if(claim.assumptions, is_phase) == 1)) {
    return true;
  }
  try {
    return !statement.during && sides_of(statement, here).decided == 1;
  } catch (const InternalError&) {  // it has no value at the point
    return false;
  }
}

}  // namespace

void look_for_witness(Outcome& outcome, const Claim& claim) {
  if (outcome.verdict.truth != Truth::undecided) {
    return;
  }
  const WorkingPrecision precision(256);
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
    const Place here{at_point(decision.verdict.witness->point), Given(claim).values};
    if (std::ranges::all_of(claim.assumptions,
                            [&](const Assumption& one) { return holds(claim, one, here); })) {
      decision.route = outcome.route;
      outcome = decision;
      return;
    }
    outcome.verdict = Verdict::undecided(
        fmt::format("{} is false at a point at which the assumptions are not known to hold", text(equation)));
  }
}

}  // namespace stickslip::proofs::methods
