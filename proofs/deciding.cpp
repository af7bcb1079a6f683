#include "proofs/deciding.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "proofs/prover.hpp"
#include "symbolic/evaluate.hpp"

namespace stickslip::proofs {
namespace {

using GiNaC::ex;

// The definitions that stay closed unless an identity needs to look inside: (6) for d0, (7) for Q.
const std::vector<symbolic::Definition>& definitions() {
  static const std::vector<symbolic::Definition> known = [] {
    const Lookup<ex> sym = symbolically();
    const model::Parameters<ex> a{sym("chi"), sym("eta"), sym("us"), sym("V"), sym("omega"), sym("p")};
    const model::Modes<ex> m{sym("omega1"), sym("omega2"), sym("lambda1"), sym("lambda2")};
    const model::Vector2<ex> d0 = model::d0<ex>(a.chi, a.us);
    const model::Vector2<ex> Q = model::Q<ex>(a, m);
    return std::vector<symbolic::Definition>{{"6.d0", {{sym("d01"), d0(0)}, {sym("d02"), d0(1)}}},
                                             {"7", {{sym("q1"), Q(0)}, {sym("q2"), Q(1)}}}};
  }();
  return known;
}

bool mentions(const Term& term, const std::string& name) {
  return (term.op() == Op::symbol && term.name() == name) ||
         std::any_of(term.arguments().begin(), term.arguments().end(),
                     [&](const Term& argument) { return mentions(argument, name); });
}

void record_free(Outcome& outcome, const symbolic::Matrix& value) {
  for (const ex& entry : value.reshaped()) {
    for (const ex& symbol : symbolic::symbols_of(entry)) {
      outcome.free.push_back(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    }
  }
  std::sort(outcome.free.begin(), outcome.free.end());
  outcome.free.erase(std::unique(outcome.free.begin(), outcome.free.end()), outcome.free.end());
}

// A plain 0 takes the shape of the other side.
symbolic::Matrix evaluate_beside(const Term& term, const Term& other, const Lookup<ex>& lookup) {
  return term.is_zero() ? symbolic::Matrix::Constant(other.shape().rows, other.shape().columns, ex(0))
                        : evaluate<ex>(term, lookup);
}

}  // namespace

// An assumption of the form "scalar = value", which is put in wherever the scalar stands.
bool is_substitution(const Assumption& assumption) {
  return assumption.statement.relation == Relation::equal && assumption.statement.left.op() == Op::symbol &&
         assumption.statement.left.shape().is_scalar();
}

// F0 and R mention the load's phase without showing it.
bool depends_on(const Term& term, const std::string& name) {
  if (mentions(term, name)) {
    return true;
  }
  const bool is_load = term.name() == "F" || term.name() == "F0" || term.name() == "R";
  return (is_load && (name == "phi" || name == "omega")) ||
         std::any_of(term.arguments().begin(), term.arguments().end(),
                     [&](const Term& argument) { return depends_on(argument, name); });
}

Given::Given(const Claim& claim) {
  for (const Assumption& assumption : claim.assumptions) {
    if (is_substitution(assumption)) {
      values.emplace(assumption.statement.left.name(), assumption.statement.right);
    }
  }
}

Lookup<ex> Given::lookup() const {
  return [this](const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? symbolically()(name) : evaluate<ex>(found->second, lookup())(0, 0);
  };
}

void record_assumptions(Outcome& outcome, const Claim& claim, const Term& term) {
  for (const Assumption& assumption : claim.assumptions) {
    if (is_substitution(assumption) && depends_on(term, assumption.statement.left.name())) {
      outcome.assumed.insert(assumption.id);
      record_assumptions(outcome, claim, assumption.statement.right);
    }
  }
}

void record_definitions(Outcome& outcome, const Claim& claim, const Term& term) {
  for (const std::string& id : definitions_in(term)) {
    if (id != claim.id) {
      outcome.uses.insert(id);
    }
  }
}

// Decides left = right and adds what that took to the outcome.
void decide(Outcome& outcome, const Claim& claim, const symbolic::Matrix& left,
            const symbolic::Matrix& right) {
  symbolic::Decision decision = symbolic::decide_equal(left, right, definitions());
  for (const ex& factor : decision.nonzero) {
    outcome.hypotheses = joined(outcome.hypotheses, {hypothesis(factor)});
  }
  decision.opened.erase(claim.id);
  outcome.uses.merge(decision.opened);
  record_free(outcome, left);
  record_free(outcome, right);
  outcome.verdict = decision.verdict;
}

void decide(Outcome& outcome, const Claim& claim, const Statement& statement) {
  if (statement.relation != Relation::equal) {
    throw InternalError("only equations are decided by normal form: " + text(statement));
  }
  const Given given(claim);
  for (const Term& side : {statement.left, statement.right}) {
    record_definitions(outcome, claim, side);
    record_assumptions(outcome, claim, side);
  }
  decide(outcome, claim, evaluate_beside(statement.left, statement.right, given.lookup()),
         evaluate_beside(statement.right, statement.left, given.lookup()));
}

}  // namespace stickslip::proofs
