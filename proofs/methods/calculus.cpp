#include "proofs/methods/calculus.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/prover.hpp"
#include "symbolic/algebra/signs.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

using GiNaC::ex;

void require(bool fits, const Claim& claim, const std::string& what) {
  if (!fits) {
    throw InternalError(fmt::format("claim {}: {}", claim.id, what));
  }
}

const Statement& only(const std::vector<Statement>& statements, const Claim& claim) {
  require(statements.size() == 1, claim, "the theorem wants premises of one statement each");
  return statements.front();
}

// Both must hold; a mere equation that does not come out refutes nothing here.
void require_equal(Outcome& outcome, const Claim& claim, const Term& left, const Term& right,
                   std::vector<Verdict>& verdicts) {
  decide(outcome, claim, equation(left, right));
  verdicts.push_back(outcome.verdict.truth == Truth::refuted
                         ? Verdict::undecided(fmt::format("{} is not {}", text(left), text(right)))
                         : outcome.verdict);
}

}  // namespace

Proof by_mean_value(MeanValue step) {
  return [step = std::move(step)](Prover& prover, const Claim& claim) {
    const Statement slope = only(statements_of(prover, claim, assuming(step.slope)), claim);
    const Statement named = only(statements_of(prover, claim, assuming(step.named)), claim);
    const Statement& printed = only(claim.printed, claim);
    const Function motion{named.left.name(), named.left.shape()};
    require(slope.relation == Relation::less && printed.relation == Relation::less, claim,
            "the mean value theorem is used for 'less'");
    require(equal(slope.left, derivative(step.row * motion(scalar("t")))) && !depends_on(slope.right, "t"),
            claim, text(slope) + " does not bound the rate of change by a constant");
    require(equal(named, equation(motion(step.upper), step.at_upper)) &&
                step.at_lower.name() == named.left.name() + "0",
            claim, text(named) + " does not say where the motion ends");
    Outcome outcome;
    outcome.route = "mean value theorem";
    outcome.assumed = {step.slope, step.named};
    std::vector<Verdict> verdicts;
    require_equal(outcome, claim, printed.left - printed.right,
                  step.row * step.at_upper - step.row * step.at_lower - slope.right * step.upper, verdicts);
    outcome.verdict = all_of(verdicts);
    return outcome;
  };
}

Proof by_periodic_decrease(PeriodicDecrease step) {
  return [step = std::move(step)](Prover& prover, const Claim& claim) {
    const Statement rate = only(statements_of(prover, claim, step.rate), claim);
    const Statement form = only(statements_of(prover, claim, step.form), claim);
    const Statement positive = only(statements_of(prover, claim, step.positive), claim);
    const Statement periodic = only(statements_of(prover, claim, assuming(step.periodic)), claim);
    require(rate.left.op() == Op::derivative && equal(rate.right, form.left), claim,
            "the two premises do not speak of one rate of change");
    require(equal(positive, Statement{step.weight, 0, Relation::greater}), claim,
            text(positive) + " does not say that the weight is positive");
    require(equal(only(claim.printed, claim), equation(step.difference, 0)), claim,
            "what follows is that the difference is zero");
    require(periodic.left.op() == Op::function && equal(periodic.left.arguments().front(), scalar("Theta")),
            claim, text(periodic) + " does not say that the difference of the motions returns");
    Outcome outcome;
    outcome.route =
        "a continuous function of period $Theta$ that never increases is constant, so its rate of change is "
        "zero at almost all times";
    for (const Premise& premise : {step.rate, step.form, step.positive, assuming(step.periodic)}) {
      record_premise(outcome, prover, claim, premise);
    }
    std::vector<Verdict> verdicts;
    require_equal(outcome, claim, form.right, -(step.weight * power(step.difference, 2)), verdicts);
    const ex quantity = evaluate<ex>(rate.left.arguments().front(), symbolically())(0, 0);
    for (const auto& [x, y] : step.motions) {
      const auto slope = [&](const Term& of) {
        return quantity.diff(GiNaC::ex_to<GiNaC::symbol>(symbolically()(of.name())));
      };
      require((slope(x) + slope(y)).expand().is_zero(), claim,
              text(rate.left) + " does not depend on the differences of the motions alone");
    }
    outcome.verdict = all_of(verdicts);
    return outcome;
  };
}

Proof by_nonzero_multiple(const std::string& assumption) {
  return [=](Prover& prover, const Claim& claim) {
    const Given given(claim);
    const Statement stated = only(statements_of(prover, claim, assuming(assumption)), claim);
    const Statement& printed = only(claim.printed, claim);
    require(stated.relation == Relation::not_equal && printed.relation == Relation::not_equal, claim,
            "one inequation follows from another");
    const auto difference = [&](const Statement& statement) {
      return evaluate<ex>(statement.left - statement.right, given.lookup())(0, 0);
    };
    Outcome outcome;
    outcome.route =
        "where the left side vanishes, so does what is assumed not to: it, or its square, is a multiple";
    outcome.assumed.insert(assumption);
    for (const Term& side : {printed.left, stated.left}) {
      record_assumptions(outcome, claim, side);
      record_definitions(outcome, claim, side);
    }
    outcome.verdict = symbolic::algebra::vanishes_with(difference(stated), difference(printed))
                          ? Verdict::proved()
                          : Verdict::undecided("no polynomial certificate was found");
    return outcome;
  };
}

}  // namespace stickslip::proofs::methods
