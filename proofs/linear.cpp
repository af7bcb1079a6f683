#include "proofs/linear.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "proofs/deciding.hpp"

namespace stickslip::proofs {
namespace {

using GiNaC::ex;

GiNaC::symbol symbol_of(const Term& unknown) {
  return GiNaC::ex_to<GiNaC::symbol>(symbolically()(unknown.name()));
}

ex coefficient_of(const ex& expression, const std::vector<Term>& unknowns, const Term& unknown) {
  GiNaC::exmap none;
  for (const Term& name : unknowns) {
    none[symbol_of(name)] = 0;
  }
  const ex part = unknown.op() == Op::symbol ? expression.diff(symbol_of(unknown)) : expression.subs(none);
  for (const auto& name : none) {
    if (part.has(name.first)) {
      throw InternalError("an expression is not linear in its unknowns");
    }
  }
  return part;
}

// "name = value" has the normal form of the value derived.
Verdict has_value(Outcome& outcome, const Claim& claim, const Statement& printed, const Named& derived) {
  if (printed.relation != Relation::equal || !equal(printed.left, derived.name)) {
    return Verdict::undecided(fmt::format("{} does not say what {} is", text(printed), text(derived.name)));
  }
  const Given given(claim);
  record_definitions(outcome, claim, printed.right);
  record_assumptions(outcome, claim, printed.right);
  decide(outcome, claim, symbolic::Matrix::Constant(1, 1, derived.value),
         evaluate<ex>(printed.right, given.lookup()));
  return outcome.verdict;
}

}  // namespace

Proof by_coefficient(const Term& name, const Term& expression, std::vector<Term> unknowns,
                     const Term& unknown) {
  return [=, unknowns = std::move(unknowns)](Prover&, const Claim& claim) {
    if (claim.printed.size() != 1) {
      throw InternalError(fmt::format("claim {} prints more than one coefficient", claim.id));
    }
    const Given given(claim);
    Outcome outcome;
    record_definitions(outcome, claim, expression);
    record_assumptions(outcome, claim, expression);
    const ex derived = coefficient_of(evaluate<ex>(expression, given.lookup())(0, 0), unknowns, unknown);
    outcome.verdict = has_value(outcome, claim, claim.printed.front(), {name, derived});
    outcome.route = "the coefficient derived from the flows and the printed one have the same normal form";
    return outcome;
  };
}

Proof by_formulas(std::function<std::vector<Named>()> values) {
  return [values = std::move(values)](Prover&, const Claim& claim) {
    const std::vector<Named> expected = values();
    if (expected.size() != claim.printed.size()) {
      throw InternalError(fmt::format("claim {} prints {} statements, {} are compared", claim.id,
                                      claim.printed.size(), expected.size()));
    }
    Outcome outcome;
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      verdicts.push_back(has_value(outcome, claim, claim.printed[i], expected[i]));
    }
    outcome.verdict = all_of(verdicts);
    outcome.route =
        "the formulas that the program computes with and the printed ones have the same normal form";
    return outcome;
  };
}

}  // namespace stickslip::proofs
