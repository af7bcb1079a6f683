#include "proofs/methods/deciding.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/symbols/derived.hpp"
#include "proofs/symbols/table.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/hypotheses.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

using GiNaC::ex;

// The definitions that stay closed unless an identity needs to look inside: (6) for d0, (7) for Q, those of
// (34) and (35), (70) for rho.
const std::vector<symbolic::algebra::Definition>& definitions() {
  static const std::vector<symbolic::algebra::Definition> none;
  if (!vocabulary_here().is_of_model()) {
    return none;
  }
  static const std::vector<symbolic::algebra::Definition> known = [] {
    std::vector<symbolic::algebra::Definition> result;
    for (const Symbol& symbol : symbol_table()) {
      if (symbol.formula_in.empty()) {
        continue;
      }
      if (result.empty() || result.back().id != symbol.formula_in) {
        result.push_back({symbol.formula_in, {}});
      }
      result.back().replacement[symbolically()(symbol.name)] =
          symbols::derived<ex>(symbol.name, symbolically()).value();
    }
    return result;
  }();
  return known;
}

// What the definitions say under the claim's assumptions.
std::vector<symbolic::algebra::Definition> definitions_under(const Given& given) {
  GiNaC::exmap values;
  for (const auto& value : given.values) {
    values[symbolically()(value.first)] = given.lookup()(value.first);
  }
  std::vector<symbolic::algebra::Definition> result = definitions();
  for (symbolic::algebra::Definition& definition : result) {
    for (auto& entry : definition.replacement) {
      entry.second = entry.second.subs(values, GiNaC::subs_options::no_pattern);
    }
  }
  return result;
}

// A factor that must not vanish, in the parameters: what that says when all definitions are open.
std::vector<ex> in_parameters(const ex& factor) {
  ex opened = factor;
  for (const symbolic::algebra::Definition& definition : definitions()) {
    opened = opened.subs(definition.replacement, GiNaC::subs_options::no_pattern);
  }
  return opened.is_equal(factor) ? std::vector<ex>{factor} : symbolic::algebra::hypotheses_of({1 / opened});
}

const Assumption& assumption_of(const Claim& claim, const std::string& id) {
  const auto found = std::find_if(claim.assumptions.begin(), claim.assumptions.end(),
                                  [&](const Assumption& assumption) { return assumption.id == id; });
  if (found == claim.assumptions.end()) {
    throw InternalError(fmt::format("claim {} does not assume {}", claim.id, id));
  }
  return *found;
}

void record_free(Outcome& outcome, const symbolic::algebra::Matrix& value) {
  for (const ex& entry : value.reshaped()) {
    for (const ex& symbol : symbolic::algebra::symbols_of(entry)) {
      outcome.free.push_back(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    }
  }
  std::sort(outcome.free.begin(), outcome.free.end());
  outcome.free.erase(std::unique(outcome.free.begin(), outcome.free.end()), outcome.free.end());
}

}  // namespace

bool is_substitution(const Assumption& assumption) {
  return assumption.statement.relation == Relation::equal && assumption.statement.left.op() == Op::symbol &&
         assumption.statement.left.shape().is_scalar() &&
         !depends_on(assumption.statement.right, assumption.statement.left.name());
}

std::set<std::string> names_in(const Term& term) {
  std::set<std::string> result;
  if (term.op() == Op::symbol) {
    result.insert(term.name());
  }
  const Symbol * row = symbol_table().find(term);
  if (row != nullptr && !row->of_time && (row->value || row->means)) {
    result.merge(names_in(row->value ? *row->value : *row->means));
  }
  const bool has_load = vocabulary_here().is_of_model();
  if (has_load && (term.name() == "F" || term.name() == "F0" || term.name() == "R")) {
    result.insert({"phi", "omega"});
  }
  for (const Term& argument : term.arguments()) {
    result.merge(names_in(argument));
  }
  return result;
}

bool depends_on(const Term& term, const std::string& name) {
  return names_in(term).contains(name);
}

Given::Given(const Claim& claim) {
  for (const Assumption& assumption : claim.assumptions) {
    if (is_substitution(assumption)) {
      if (leads_to(assumption.statement.right, assumption.statement.left.name())) {
        throw InternalError(fmt::format("claim {}: it gives {} a value in terms of itself", claim.id,
                                        assumption.statement.left.name()));
      }
      values.emplace(assumption.statement.left.name(), assumption.statement.right);
    }
  }
}

bool Given::leads_to(const Term& term, const std::string& name) const {
  const std::set<std::string> names = names_in(term);
  return names.contains(name) || std::ranges::any_of(names, [&](const std::string& one) {
           const auto value = values.find(one);
           return value != values.end() && leads_to(value->second, name);
         });
}

Lookup<ex> Given::lookup() const {
  return [this](const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? symbolically()(name) : evaluate<ex>(found->second, lookup())(0, 0);
  };
}

std::vector<Statement> statements_of(Prover& prover, const Claim& claim, const Premise& premise) {
  std::vector<Statement> statements;
  if (premise.assumed) {
    statements = {assumption_of(claim, premise.id).statement};
  } else {
    statements = proved_form(prover.prove(premise.id));
  }
  for (Statement& statement : statements) {
    statement = substitute(statement, premise.replacements);
  }
  return statements;
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

void record_nonzero(Outcome& outcome, const Claim& claim, const ex& factor) {
  for (const ex& part : in_parameters(factor)) {
    outcome.hypotheses = joined(outcome.hypotheses, {hypothesis(part, claim.id)});
  }
}

namespace {

void record_decision(Outcome& outcome, const Claim& claim, const symbolic::algebra::Decision& decision) {
  for (const ex& factor : decision.nonzero) {
    record_nonzero(outcome, claim, factor);
  }
  outcome.uses.insert(decision.opened.begin(), decision.opened.end());
  outcome.uses.erase(claim.id);
}

}  // namespace

void decide(Outcome& outcome, const Claim& claim, const symbolic::algebra::Matrix& left,
            const symbolic::algebra::Matrix& right) {
  const symbolic::algebra::Decision decision =
      symbolic::algebra::decide_equal(left, right, definitions_under(Given(claim)));
  record_decision(outcome, claim, decision);
  record_free(outcome, left);
  record_free(outcome, right);
  outcome.verdict = decision.verdict;
  outcome.decided.push_back({{}, left, right, decision.verdict.truth});
}

void decide(Outcome& outcome, const Claim& claim, const Statement& statement) {
  if (statement.relation != Relation::equal) {
    throw InternalError("only equations are decided by normal form: " + text(statement));
  }
  const Given given(claim);
  for (const Term& side : {statement.left, statement.right}) {
    record_definitions(outcome, claim, side);
  }
  const symbolic::algebra::Matrix left = evaluate_beside<ex>(statement.left, statement.right, given.lookup()),
                                  right =
                                      evaluate_beside<ex>(statement.right, statement.left, given.lookup());
  const symbolic::algebra::Decision decision =
      symbolic::algebra::decide_equal(left, right, definitions_under(given));
  for (const Term& side : {statement.left, statement.right}) {
    record_assumptions(outcome, claim, side);
  }
  record_decision(outcome, claim, decision);
  outcome.verdict = decision.verdict;
  record_free(outcome, left);
  record_free(outcome, right);
  outcome.decided.push_back({statement, left, right, decision.verdict.truth});
}

}  // namespace stickslip::proofs::methods
