#include "proofs/checks/cross_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "proofs/checks/premises.hpp"
#include "proofs/kernel/entrywise.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/symbols/sample.hpp"

namespace stickslip::proofs::checks {

using namespace numeric::scalars;
using namespace methods;
using namespace symbols;

namespace {

constexpr int exact_points = 2, ball_points = 1;
constexpr std::size_t points_at_premises = 2;
constexpr unsigned draws = 40;  // of each point, until no denominator vanishes and all that is assumed holds

// Numbers of points for the claim, no others than before on any run.
unsigned seed_of(const Claim& claim) {
  return std::accumulate(claim.id.begin(), claim.id.end(), 7U,
                         [](unsigned seed, char c) { return 31 * seed + static_cast<unsigned char>(c); });
}

// What the terms that a proof derived are worth at a point.
template <class S>
struct At {
  using Number = S;
  Sample<S> * symbols;

  [[nodiscard]] static S number(const Rational& value) { return S(value); }
  [[nodiscard]] S pi() const { return (*symbols)("pi"); }
  [[nodiscard]] static S reciprocal(const S& value) { return S(1) / value; }
  [[nodiscard]] static S cosine(const kernel::Term& argument, auto& entries) {
    return cos(entries(argument)[0]);
  }
  [[nodiscard]] static S sine(const kernel::Term& argument, auto& entries) {
    return sin(entries(argument)[0]);
  }
  [[nodiscard]] static S exponential(const kernel::Term& argument, auto& entries) {
    return exp(entries(argument)[0]);
  }
  [[nodiscard]] std::vector<S> atom(const kernel::Term& term, auto& entries) const {
    if (term.kind() == kernel::Kind::defined) {
      return entries(term.definition().unfolded(term.parts()));
    }
    if (term.kind() != kernel::Kind::variable || !term.type().is_scalar()) {
      throw InternalError("a proof derived an equation of what is no number");
    }
    return {(*symbols)(term.name())};
  }
};

template <class S>
Sides<S> sides(const Decided& decided, Sample<S>& at) {
  if (decided.statement) {
    return both_sides<S>(*decided.statement, at.lookup());
  }
  kernel::Entrywise<At<S>> entries({&at});
  const auto column = [&](const kernel::Term& term) {
    const std::vector<S>& values = entries(term);
    return Value<S>(Eigen::Map<const Value<S>>(values.data(), static_cast<Eigen::Index>(values.size()), 1));
  };
  return {column(decided.left), column(decided.right)};
}

// The claim's formulas at one point: exactly, or with the same parameters and times as balls, but for those
// that are fixed; pi is pi there.
template <class S>
struct AtPoint {
  ExactPoint point;
  std::vector<Coordinate> fixed;
  Sample<S> at;

  AtPoint(const Replacements& given, unsigned seed, std::vector<Coordinate> those = {})
      : point(seed),
        fixed(std::move(those)),
        at(given, [this](const std::string& name) { return value(name); }) {}

  [[nodiscard]] Sides<S> operator()(const Decided& decided) { return sides(decided, at); }

  [[nodiscard]] S value(const std::string& name) const {
    if constexpr (std::is_same_v<S, Exact>) {
      return point.symbol(name);
    } else {
      const auto known = std::ranges::find(fixed, name, &Coordinate::name);
      return known != fixed.end() ? Ball(known->value)
             : name == "pi"       ? Ball::pi()
                                  : Ball(point.symbol(name).value());
    }
  }
};

bool are_equal(const Sides<Exact>& at) {
  return std::equal(at.left.data(), at.left.data() + at.left.size(), at.right.data(),
                    [](const Exact& a, const Exact& b) { return a.value() == b.value(); });
}

bool disjoint(const Sides<Ball>& at) {
  for (Eigen::Index i = 0; i < at.left.size(); ++i) {
    if (!at.left(i).overlaps(at.right(i))) {
      return true;
    }
  }
  return false;
}

// Whether the balls of both sides are small beside their values: not the two sides of anything overlap then.
bool tell_much(const Sides<Ball>& at) {
  const Ball bound = Ball(1) / Ball(1L << 40);
  for (Eigen::Index i = 0; i < at.left.size(); ++i) {
    const Ball size = Ball(1) + abs(at.left(i)) + abs(at.right(i));
    if (!(at.left(i) - at.right(i)).is_finite() ||
        !((at.left(i) - at.right(i)).radius() - bound * size).is_negative()) {
      return false;
    }
  }
  return true;
}

bool is_equation(const Decided& decided) {
  return !decided.statement || decided.statement->relation == Relation::equal;
}

// Whether the relation fails, as far as balls tell: they cannot say that two sides are equal, only that they
// overlap where they are small.
bool fails(Relation relation, const Sides<Ball>& at) {
  const auto less = [](const Value<Ball>& a, const Value<Ball>& b) {
    return std::equal(a.data(), a.data() + a.size(), b.data(),
                      [](const Ball& x, const Ball& y) { return (x - y).is_negative(); });
  };
  const auto agree = [&] { return !disjoint(at) && tell_much(at); };
  switch (relation) {
    case Relation::equal:
      return disjoint(at);
    case Relation::not_equal:
      return agree();
    case Relation::less:
      return agree() || less(at.right, at.left);
    case Relation::less_or_equal:
      return less(at.right, at.left);
    case Relation::greater:
      return agree() || less(at.left, at.right);
    case Relation::greater_or_equal:
      return less(at.left, at.right);
  }
  return false;
}

bool fails_at(const Claim& claim, const Decided& decided, const Witness& witness) {
  const WorkingPrecision precision(256);
  const Given given(claim);
  AtPoint<Ball> at(given.values, seed_of(claim), witness.point);
  return fails(decided.statement ? decided.statement->relation : Relation::equal, at(decided));
}

struct Disagreement {
  const Claim& claim;
  [[noreturn]] void operator()(const std::string& what) const {
    throw InternalError(fmt::format("claim {}: the two engines disagree: {}", claim.id, what));
  }
};

std::string name_of(const Decided& decided) {
  return decided.statement ? text(*decided.statement) : "an equation that the proof derived";
}

// How many rational points agree with the verdict on all formulas.
int confirmed_exactly(const Claim& claim, const std::vector<Decided>& all, bool proved) {
  const Given given(claim);
  int confirmed = 0;
  for (unsigned draw = 0; draw < draws && confirmed < exact_points; ++draw) {
    AtPoint<Exact> at(given.values, seed_of(claim) + draw);
    try {
      const auto agrees = [&](const Decided& one) {
        const bool holds = are_equal(at(one));
        if (proved && !holds) {
          Disagreement{claim}(name_of(one) + " is called proved and fails at a rational point");
        }
        return proved || !holds;
      };
      confirmed += std::ranges::all_of(all, agrees) ? 1 : 0;
    } catch (const ZeroDivision&) {
      continue;
    }
  }
  if (!proved && confirmed == 0) {
    Disagreement{claim}("what is called refuted holds at all rational points tried");
  }
  return confirmed;
}

// At that many points the balls of both sides overlap and are small.
int confirmed_in_balls(const Claim& claim, const std::vector<Decided>& all) {
  const Given given(claim);
  int confirmed = 0;
  for (unsigned draw = 0; draw < draws && confirmed < ball_points; ++draw) {
    AtPoint<Ball> at(given.values, seed_of(claim) + draw);
    bool all_tell = true;
    for (const Decided& one : all) {
      const Sides<Ball> here = at(one);
      if (disjoint(here)) {
        Disagreement{claim}(name_of(one) + " is called proved and fails in balls");
      }
      all_tell = all_tell && tell_much(here);
    }
    confirmed += all_tell ? 1 : 0;
  }
  return confirmed;
}

// The refuted formulas at the witness, where those of one must be disjoint.
int confirmed_at_witness(const Claim& claim, const std::vector<Decided>& all, const Witness& witness) {
  if (std::ranges::none_of(all, [&](const Decided& one) { return fails_at(claim, one, witness); })) {
    Disagreement{claim}("in balls, what is called refuted does not fail at the witness");
  }
  return 1;
}

// Whether it differentiates symbols that stand for a motion.
bool differentiates_motion(const Term& term) {
  return (term.op() == Op::derivative && !depends_on(term, "t")) ||
         std::ranges::any_of(term.arguments(), differentiates_motion);
}

// What is said to be equal to a scalar without a value is its name.
bool can_be_evaluated(const Statement& statement) {
  const auto has_value = [](const Term& side) { return is_in_field(side) && !differentiates_motion(side); };
  return has_value(statement.left) && has_value(statement.right) && !stands_for_itself(statement.left);
}

// Which equations that the claim assumes keep its statements from being identities.
std::string conditions(const Claim& claim, const Outcome& outcome) {
  std::string ids;
  const Given given(claim);
  for (const Assumption& assumption : claim.assumptions) {
    if (outcome.assumed.contains(assumption.id) && assumption.statement.relation == Relation::equal &&
        !given.takes(assumption)) {
      ids += (ids.empty() ? "" : ", ") + assumption.id;
    }
  }
  return ids;
}

// Of a motion printed in closed form: the differential equation and the initial state that the claim assumes.
std::vector<Decided> of_closed_form(const Claim& claim) {
  std::vector<Decided> result;
  const Term t = scalar("t");
  for (const Statement& printed : claim.printed) {
    if (!vocabulary_here().is_of_model() || printed.left.name() != "Z" ||
        !equal(printed.left.arguments().front(), t) || !is_in_field(printed.right)) {
      continue;
    }
    Premises motion;
    motion.motions.emplace("X", printed.right + vector("delta0", 4));
    for (const Assumption& assumption : claim.assumptions) {
      const Statement& assumed = assumption.statement;
      if (assumed.during && assumed.left.op() == Op::derivative) {
        const Statement here = motion.with_motions({assumed.left, assumed.right, Relation::equal});
        result.push_back({here});
      } else if (assumed.left.op() == Op::function && assumed.left.name() == "Z") {
        const Replacements then{{"t", assumed.left.arguments().front()}};
        result.push_back({equation(substitute(printed.right, then), assumed.right)});
      }
    }
  }
  return result;
}

std::vector<Decided> formulas(const Claim& claim, const Outcome& outcome, bool with_printed) {
  std::vector<Decided> result;
  if (outcome.verdict.truth == Truth::proved) {
    result = of_closed_form(claim);
  }
  result.insert(result.end(), outcome.decided.begin(), outcome.decided.end());
  if (with_printed && outcome.verdict.truth == Truth::proved) {
    for (const Statement& printed : claim.printed) {
      const bool done = std::ranges::any_of(
          result, [&](const Decided& one) { return one.statement && equal(*one.statement, printed); });
      if (!done && printed.relation == Relation::equal && can_be_evaluated(printed)) {
        result.push_back({printed});
      }
    }
  }
  return result;
}

bool all_identities(Prover& prover, const std::set<std::string>& claims) {
  return std::ranges::all_of(claims, [&](const std::string& id) {
    const Record& premise = prover.prove(id);
    return final_outcome(premise).cross_check.identity;
  });
}

// At that many points where what the claim rests on holds, what it prints holds, too. Where some of that
// could not be evaluated, what is printed may fail.
int confirmed_at_premises(Prover& prover, const Claim& claim, const Outcome& outcome) {
  const Premises premises = premises_of(prover, claim, outcome);
  int confirmed = 0;
  for (const PremisePoint& point : premise_points(premises, points_at_premises)) {
    bool all_hold = true;
    for (const Statement& printed : claim.printed) {
      try {
        if (premises.left_out.empty() && point.contradicts(printed)) {
          Disagreement{claim}(text(printed) + " is called proved and fails where all that it rests on holds");
        }
        all_hold = all_hold && point.confirms(printed);
      } catch (const NoValue&) {
        all_hold = false;
      }
    }
    confirmed += all_hold ? 1 : 0;
  }
  return confirmed;
}

}  // namespace

bool fails_at(const Claim& claim, const Statement& statement, const Witness& witness) {
  return fails_at(claim, Decided{statement}, witness);
}

CrossCheck cross_check(Prover& prover, const Claim& claim, const Outcome& outcome) {
  CrossCheck result;
  const bool proved = outcome.verdict.truth == Truth::proved;
  const std::string assumed = conditions(claim, outcome);
  const bool evaluable = std::ranges::all_of(claim.printed, can_be_evaluated);
  const bool unconditional = assumed.empty() && all_identities(prover, outcome.uses);
  result.identity = unconditional && evaluable && !claim.printed.empty() && proved;
  const std::vector<Decided> all = formulas(claim, outcome, unconditional);
  result.formulas = static_cast<int>(all.size());
  if (all.empty()) {
    if (proved && !claim.printed.empty()) {
      result.premise_points = confirmed_at_premises(prover, claim, outcome);
    }
    if (result.premise_points > 0) {
      result.formulas = static_cast<int>(claim.printed.size());
    } else {
      result.unchecked = !proved                 ? "the witness itself was found in balls"
                         : claim.printed.empty() ? "there is no formula to evaluate"
                         : assumed.empty()
                             ? "no point is known where its premises hold"
                             : "no point is known where its premises and what it assumes hold: " + assumed;
    }
    return result;
  }
  try {
    // An inequality that fails at the witness may hold at most points.
    result.exact_points = std::ranges::all_of(all, is_equation) ? confirmed_exactly(claim, all, proved) : 0;
  } catch (const NoExactValue& reason) {
    result.unchecked = reason.what();
  }
  result.ball_points = proved ? confirmed_in_balls(claim, all)
                              : confirmed_at_witness(claim, all, outcome.verdict.witness.value());
  return result;
}

}  // namespace stickslip::proofs::checks
