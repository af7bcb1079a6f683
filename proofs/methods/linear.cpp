#include "proofs/methods/linear.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"

namespace stickslip::proofs::methods {

using namespace numeric::scalars;
using namespace symbols;

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

Verdict unknown_name(const Statement& printed) {
  return Verdict::undecided(text(printed) + " gives no value to a name that is known here");
}

// The printed right side has the normal form of the value derived.
Verdict has_value(Outcome& outcome, const Claim& claim, const Statement& printed, const ex& derived) {
  const Given given(claim);
  record_definitions(outcome, claim, printed.right);
  record_assumptions(outcome, claim, printed.right);
  decide(outcome, claim, symbolic::algebra::Matrix::Constant(1, 1, derived),
         evaluate<ex>(printed.right, given.lookup()));
  return outcome.verdict;
}

}  // namespace

Proof by_coefficient(std::function<std::optional<Coefficient>(const Term& name)> named,
                     std::vector<Term> unknowns) {
  return [named = std::move(named), unknowns = std::move(unknowns)](Prover&, const Claim& claim) {
    const Given given(claim);
    Outcome outcome;
    std::vector<Verdict> verdicts;
    for (const Statement& printed : claim.printed) {
      const auto which = printed.relation == Relation::equal ? named(printed.left) : std::nullopt;
      if (!which) {
        verdicts.push_back(unknown_name(printed));
        continue;
      }
      record_definitions(outcome, claim, which->expression);
      record_assumptions(outcome, claim, which->expression);
      const ex expression = evaluate<ex>(which->expression, given.lookup())(0, 0);
      verdicts.push_back(
          has_value(outcome, claim, printed, coefficient_of(expression, unknowns, which->unknown)));
    }
    outcome.verdict = all_of(verdicts);
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
    for (const Statement& printed : claim.printed) {
      const auto named = std::find_if(expected.begin(), expected.end(),
                                      [&](const Named& one) { return equal(one.name, printed.left); });
      const bool known = printed.relation == Relation::equal && named != expected.end();
      verdicts.push_back(known ? has_value(outcome, claim, printed, named->value) : unknown_name(printed));
    }
    outcome.verdict = all_of(verdicts);
    outcome.route =
        "the formulas that the program computes with and the printed ones have the same normal form";
    return outcome;
  };
}

}  // namespace stickslip::proofs::methods
