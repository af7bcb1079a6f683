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

}  // namespace

Proof by_coefficient(const Term& expression, std::vector<Term> unknowns, const Term& unknown) {
  return [=, unknowns = std::move(unknowns)](Prover&, const Claim& claim) {
    if (claim.printed.size() != 1) {
      throw InternalError(fmt::format("claim {} prints more than one coefficient", claim.id));
    }
    const Given given(claim);
    const Term& stated = claim.printed.front().right;
    Outcome outcome;
    for (const Term& side : {expression, stated}) {
      record_definitions(outcome, claim, side);
      record_assumptions(outcome, claim, side);
    }
    const ex derived =
        coefficient_of(evaluate<ex>(expression, given.lookup())(0, 0), unknowns, unknown);
    const Value<ex> read = stated.is_zero() ? Value<ex>::Constant(1, 1, ex(0))
                                            : evaluate<ex>(stated, given.lookup());
    decide(outcome, claim, symbolic::Matrix::Constant(1, 1, derived), read);
    outcome.route = "the coefficient derived from the flows and the printed one have the same normal form";
    return outcome;
  };
}

Proof by_formulas(std::function<std::vector<ex>()> values) {
  return [values = std::move(values)](Prover&, const Claim& claim) {
    const Given given(claim);
    const std::vector<ex> expected = values();
    if (expected.size() != claim.printed.size()) {
      throw InternalError(fmt::format("claim {} prints {} statements, {} are compared", claim.id,
                                      claim.printed.size(), expected.size()));
    }
    Outcome outcome;
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Term& stated = claim.printed[i].right;
      record_definitions(outcome, claim, stated);
      decide(outcome, claim, symbolic::Matrix::Constant(1, 1, expected[i]),
             evaluate<ex>(stated, given.lookup()));
      verdicts.push_back(outcome.verdict);
    }
    outcome.verdict = all_of(verdicts);
    outcome.route = "the formulas that the program computes with and the printed ones have the same normal form";
    return outcome;
  };
}

}  // namespace stickslip::proofs
