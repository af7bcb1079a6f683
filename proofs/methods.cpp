#include "proofs/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/meaning.hpp"
#include "proofs/prover.hpp"
#include "proofs/rewrite.hpp"
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

// An assumption of the form "scalar = value", which is put in wherever the scalar stands.
bool is_substitution(const Assumption& assumption) {
  return assumption.statement.relation == Relation::equal && assumption.statement.left.op() == Op::symbol &&
         assumption.statement.left.shape().is_scalar();
}

bool mentions(const Term& term, const std::string& name) {
  return (term.op() == Op::symbol && term.name() == name) ||
         std::any_of(term.arguments().begin(), term.arguments().end(),
                     [&](const Term& argument) { return mentions(argument, name); });
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

// What the claim's assumptions give to scalars, and which assumptions the terms needed.
struct Given {
  std::map<std::string, Term> values;

  explicit Given(const Claim& claim) {
    for (const Assumption& assumption : claim.assumptions) {
      if (is_substitution(assumption)) {
        values.emplace(assumption.statement.left.name(), assumption.statement.right);
      }
    }
  }

  [[nodiscard]] Lookup<ex> lookup() const {
    return [this](const std::string& name) {
      const auto found = values.find(name);
      return found == values.end() ? symbolically()(name) : evaluate<ex>(found->second, lookup())(0, 0);
    };
  }
};

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

void record_free(Outcome& outcome, const symbolic::Matrix& value) {
  for (const ex& entry : value.reshaped()) {
    for (const ex& symbol : symbolic::symbols_of(entry)) {
      outcome.free.push_back(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    }
  }
  std::sort(outcome.free.begin(), outcome.free.end());
  outcome.free.erase(std::unique(outcome.free.begin(), outcome.free.end()), outcome.free.end());
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

// A plain 0 takes the shape of the other side.
symbolic::Matrix evaluate_beside(const Term& term, const Term& other, const Lookup<ex>& lookup) {
  return term.is_zero() ? symbolic::Matrix::Constant(other.shape().rows, other.shape().columns, ex(0))
                        : evaluate<ex>(term, lookup);
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

Outcome conjunction(const std::string& route, const Claim& claim, const std::vector<Statement>& equations) {
  Outcome outcome;
  std::vector<Verdict> verdicts;
  for (const Statement& equation : equations) {
    decide(outcome, claim, equation);
    verdicts.push_back(outcome.verdict);
  }
  outcome.verdict = all_of(verdicts);
  outcome.route = route;
  return outcome;
}

const char* const normal_form_route = "both sides have the same normal form, for all values of the symbols";

}  // namespace

Proof by_normal_form() {
  return [](Prover&, const Claim& claim) { return conjunction(normal_form_route, claim, claim.printed); };
}

Proof by_normal_form(std::vector<Statement> equations) {
  return [equations = std::move(equations)](Prover&, const Claim& claim) {
    return conjunction(normal_form_route, claim, equations);
  };
}

Proof by_derivation(const std::string& route, std::function<std::vector<Derived>()> derive) {
  return [route, derive = std::move(derive)](Prover&, const Claim& claim) {
    Outcome outcome;
    std::vector<Verdict> verdicts;
    for (const Derived& derived : derive()) {
      record_definitions(outcome, claim, derived.stated);
      decide(outcome, claim, derived.value, evaluate<ex>(derived.stated, symbolically()));
      verdicts.push_back(outcome.verdict);
    }
    outcome.verdict = all_of(verdicts);
    outcome.route = route;
    return outcome;
  };
}

Proof by_differential_equation(const Term& A, const Term& forcing, const Term& initial, const Term& start) {
  return [=](Prover&, const Claim& claim) {
    const Term& solution = claim.printed.front().right;
    return conjunction(
        "it satisfies the differential equation and the initial value; linear equations have one solution",
        claim,
        {equation(derivative(solution), A * solution + forcing),
         equation(substitute(solution, {{"t", start}}), initial)});
  };
}

Premise Premise::at(const std::string& symbol, const Term& value) const {
  Premise result = *this;
  result.replacements.emplace(symbol, value);
  return result;
}

Premise Premise::solved_for(const Term& product) const {
  Premise result = *this;
  result.lead = product;
  return result;
}

Premise from(const std::string& id) {
  return {id, false, {}, {}};
}
Premise assuming(const std::string& id) {
  return {id, true, {}, {}};
}

namespace {

const Assumption& assumption_of(const Claim& claim, const std::string& id) {
  const auto found = std::find_if(claim.assumptions.begin(), claim.assumptions.end(),
                                  [&](const Assumption& assumption) { return assumption.id == id; });
  if (found == claim.assumptions.end()) {
    throw InternalError(fmt::format("claim {} does not assume {}", claim.id, id));
  }
  return *found;
}

// A claim may serve as a premise only where what it assumes itself is assumed here too, unchanged.
void check_assumptions(const Claim& user, const Claim& used, const Premise& premise) {
  for (const Assumption& assumption : used.assumptions) {
    (void)assumption_of(user, assumption.id);
    for (const auto& replacement : premise.replacements) {
      if (depends_on(assumption.statement.left, replacement.first) ||
          depends_on(assumption.statement.right, replacement.first)) {
        throw InternalError(fmt::format("claim {} uses {} with another {} than the one assumed in {}",
                                        user.id, used.id, replacement.first, assumption.id));
      }
    }
  }
}

std::vector<Statement> statements_of(Prover& prover, const Claim& claim, const Premise& premise) {
  if (premise.assumed) {
    return {assumption_of(claim, premise.id).statement};
  }
  const Record& record = prover.prove(premise.id);
  check_assumptions(claim, record.claim, premise);
  return proved_form(record);
}

// The statements of a premise that can be solved for what it is to be solved for; at least one.
std::vector<Rule> rules_of(Prover& prover, const Claim& claim, const Premise& premise,
                           const std::vector<Rule>& known) {
  const Given given(claim);
  std::vector<Rule> rules;
  for (const Statement& general : statements_of(prover, claim, premise)) {
    const Statement statement = substitute(general, premise.replacements);
    const Polynomial lead = polynomial(premise.lead.value_or(statement.left), given.lookup());
    if (auto rule = solve(residual(statement, given.lookup()), lead, premise.id, known)) {
      rules.push_back(*std::move(rule));
    }
  }
  if (rules.empty()) {
    throw InternalError(
        fmt::format("claim {}: the premise {} cannot be solved as wanted", claim.id, premise.id));
  }
  return rules;
}

std::vector<Rule> rules_of(Prover& prover, const Claim& claim, const std::vector<Premise>& premises) {
  std::vector<Rule> rules;
  for (const Premise& premise : premises) {
    std::vector<Rule> more = rules_of(prover, claim, premise, rules);
    rules.insert(rules.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return rules;
}

}  // namespace

Proof by_rewriting(std::vector<Premise> premises) {
  return [premises = std::move(premises)](Prover& prover, const Claim& claim) {
    const std::vector<Rule> rules = rules_of(prover, claim, premises);
    const Given given(claim);
    Outcome outcome;
    outcome.route = "replacing equals by equals, with the premises listed";
    outcome.verdict = Verdict::proved();
    for (const Statement& statement : claim.printed) {
      const Rewritten rewritten = rewrite(residual(statement, given.lookup()), rules);
      if (!rewritten.rest.empty()) {
        outcome.verdict = Verdict::undecided("the premises leave " + text(rewritten.rest));
      }
      for (const Premise& premise : premises) {
        if (rewritten.sources.contains(premise.id)) {
          (premise.assumed ? outcome.assumed : outcome.uses).insert(premise.id);
        }
      }
      record_assumptions(outcome, claim, statement.left);
      record_assumptions(outcome, claim, statement.right);
    }
    return outcome;
  };
}

}  // namespace stickslip::proofs
