#include "proofs/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/rewrite.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

using GiNaC::ex;

void decide_all(Outcome& outcome, const Claim& claim, const std::vector<Statement>& equations,
                std::vector<Verdict>& verdicts) {
  for (const Statement& equation : equations) {
    decide(outcome, claim, equation);
    verdicts.push_back(outcome.verdict);
  }
}

Outcome conjunction(const std::string& route, const Claim& claim, const std::vector<Statement>& equations) {
  Outcome outcome;
  std::vector<Verdict> verdicts;
  decide_all(outcome, claim, equations, verdicts);
  outcome.verdict = all_of(verdicts);
  outcome.route = route;
  return outcome;
}

// The printed statements that speak of nothing but what has a value.
std::vector<Statement> with_values(std::vector<Statement> printed) {
  std::erase_if(printed,
                [](const Statement& one) { return !is_in_field(one.left) || !is_in_field(one.right); });
  return printed;
}

const char * const normal_form_route = "both sides have the same normal form, for all values of the symbols";

// By normal form, of the claim's printed equations: a theorem of the kernel if all are.
Outcome by_normal_form(const Claim& claim, const std::vector<Statement>& equations) {
  Outcome outcome = conjunction(normal_form_route, claim, equations);
  outcome.by_kernel = outcome.verdict.truth == Truth::proved && outcome.theorems.size() == equations.size();
  return outcome;
}

}  // namespace

Proof by_normal_form() {
  return [](Prover&, const Claim& claim) { return by_normal_form(claim, claim.printed); };
}

Proof by_normal_form(std::vector<Statement> equations) {
  return [equations = std::move(equations)](Prover&, const Claim& claim) {
    std::vector<Statement> all = with_values(claim.printed);
    all.insert(all.end(), equations.begin(), equations.end());
    Outcome outcome = by_normal_form(claim, all);
    // What is printed and has no value is no theorem: others only say what it means.
    outcome.by_kernel = outcome.by_kernel && with_values(claim.printed).size() == claim.printed.size();
    return outcome;
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
    decide_all(outcome, claim, claim.printed, verdicts);
    outcome.verdict = all_of(verdicts);
    outcome.route = route;
    return outcome;
  };
}

Proof by_differential_equation(const Term& A, const Term& forcing, const Term& initial, const Term& start) {
  return [=](Prover&, const Claim& claim) {
    // Time counted from the start: fewer phases for the normal form.
    const Replacements from_start{{"t", scalar("t") + start}};
    const Term solution = substitute(claim.printed.front().right, from_start);
    Outcome outcome = conjunction(
        "it satisfies the differential equation and the initial value; linear equations have one solution",
        claim,
        {equation(derivative(solution), A * solution + substitute(forcing, from_start)),
         equation(substitute(solution, {{"t", 0}}), initial)});
    const Statement begins = equation(substitute(claim.printed.front().left, {{"t", start}}), initial);
    for (const Assumption& assumption : claim.assumptions) {
      if (equal(assumption.statement, begins)) {
        outcome.assumed.insert(assumption.id);
      }
    }
    return outcome;
  };
}

Premise Premise::at(const std::string& symbol, const Term& value) const {
  Premise result = *this;
  result.replacements.emplace(symbol, value);
  return result;
}

Premise Premise::given(const std::string& assumption, const std::string& claim) const {
  Premise result = *this;
  result.supplied.emplace(assumption, claim);
  return result;
}

Premise Premise::solved_for(const Term& product) const {
  Premise result = *this;
  result.lead = product;
  return result;
}

Premise Premise::divided_by(const Term& square) const {
  Premise result = *this;
  result.factor = square;
  return result;
}

Premise from(const std::string& id) {
  return {.id = id};
}
Premise assuming(const std::string& id) {
  return {.id = id, .assumed = true};
}

namespace {

// A^{-1} A = I.
Rule cancellation(const Claim& claim, const Term& square, const Lookup<ex>& lookup) {
  for (const Assumption& assumption : claim.assumptions) {
    const Statement& stated = assumption.statement;
    if (stated.relation == Relation::not_equal && equal(stated.left, determinant(square)) &&
        stated.right.is_zero()) {
      return {polynomial(inverse(square) * square, lookup).begin()->first, {{{}, 1}}, {assumption.id}};
    }
  }
  throw InternalError(
      fmt::format("claim {} divides by {} without assuming that it can", claim.id, text(square)));
}

// The statements of a premise that can be solved for what it is to be solved for; at least one.
std::vector<Rule> rules_of(Prover& prover, const Claim& claim, const Premise& premise,
                           const std::vector<Rule>& known) {
  const Given given(claim);
  std::vector<Rule> rules;
  std::vector<Rule> simplifying = known;
  if (premise.factor) {
    simplifying.push_back(cancellation(claim, *premise.factor, given.lookup()));
  }
  for (Statement statement : statements_of(prover, claim, premise)) {
    if (premise.factor) {
      const Term left = inverse(*premise.factor);
      statement = {left * statement.left,
                   statement.right.is_zero() ? statement.right : left * statement.right, statement.relation};
    }
    const Polynomial lead = polynomial(premise.lead.value_or(statement.left), given.lookup());
    if (auto rule = solve(residual(statement, given.lookup()), lead, premise.id, simplifying)) {
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
      for (const Assumption& assumption : claim.assumptions) {
        if (rewritten.sources.contains(assumption.id)) {
          outcome.assumed.insert(assumption.id);
        }
      }
      for (const Premise& premise : premises) {
        if (rewritten.sources.contains(premise.id)) {
          record_premise(outcome, prover, claim, premise);
        }
      }
      record_assumptions(outcome, claim, statement.left);
      record_assumptions(outcome, claim, statement.right);
    }
    return outcome;
  };
}

Proof by_premises(std::vector<Premise> premises) {
  return [premises = std::move(premises)](Prover& prover, const Claim& claim) {
    Outcome outcome;
    outcome.route = "what the premises say; what they assume beyond this is supplied by the claims listed";
    outcome.verdict = Verdict::proved();
    for (const Statement& printed : claim.printed) {
      const auto made_by = [&](const Premise& premise) {
        const std::vector<Statement> made = statements_of(prover, claim, premise);
        return std::any_of(made.begin(), made.end(),
                           [&](const Statement& one) { return equal(one, printed); });
      };
      const auto source = std::find_if(premises.begin(), premises.end(), made_by);
      if (source == premises.end()) {
        outcome.verdict = Verdict::undecided(fmt::format("no premise says {}", text(printed)));
        continue;
      }
      record_premise(outcome, prover, claim, *source);
    }
    return outcome;
  };
}

}  // namespace stickslip::proofs::methods
