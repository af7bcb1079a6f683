#include "proofs/methods/deciding.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
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
          derived<ex>(symbol.name, symbolically()).value();
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

bool says(const Record& record, const Statement& statement) {
  const std::vector<Statement>& said = proved_form(record);
  return std::any_of(said.begin(), said.end(), [&](const Statement& one) { return equal(one, statement); });
}

// The claim that takes the place of an assumption, for a premise that has it.
Premise supplier(const Premise& premise, const std::string& id) {
  Premise result = from(id);
  result.supplied = premise.supplied;
  return result;
}

// A claim may serve as a premise only where what it assumes itself is assumed here too, unchanged, or is
// supplied by a claim for which the same holds. A corrected form needs what its own proof took.
void check_assumptions(Prover& prover, const Claim& user, const Record& record, const Premise& premise) {
  const Claim& used = record.claim;
  for (const Assumption& assumption : used.assumptions) {
    if (record.corrected && !record.corrected->assumed.contains(assumption.id)) {
      continue;
    }
    for (const auto& replacement : premise.replacements) {
      if (depends_on(assumption.statement.left, replacement.first) ||
          depends_on(assumption.statement.right, replacement.first)) {
        throw InternalError(fmt::format("claim {} uses {} with another {} than the one assumed in {}",
                                        user.id, used.id, replacement.first, assumption.id));
      }
    }
    if (const auto supplied = premise.supplied.find(assumption.id); supplied != premise.supplied.end()) {
      const Record& supplier_record = prover.prove(supplied->second);
      if (!says(supplier_record, assumption.statement)) {
        throw InternalError(fmt::format("claim {}: {} does not say what {} assumes as {}", user.id,
                                        supplied->second, used.id, assumption.id));
      }
      check_assumptions(prover, user, supplier_record, supplier(premise, supplied->second));
    } else if (!equal(assumption_of(user, assumption.id).statement, assumption.statement)) {
      throw InternalError(
          fmt::format("claim {} assumes another {} than {}", user.id, assumption.id, used.id));
    }
  }
}

// What must not vanish, with the premise's replacements and under the claim's assumptions.
std::vector<ex> instantiated(const ex& nonzero, const Premise& premise, const Given& given) {
  GiNaC::exmap values;
  for (const ex& symbol : symbolic::algebra::symbols_of(nonzero)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
    const auto replaced = premise.replacements.find(name);
    values[symbol] = replaced == premise.replacements.end()
                         ? given.lookup()(name)
                         : evaluate<ex>(replaced->second, given.lookup())(0, 0);
  }
  const ex here = nonzero.subs(values, GiNaC::subs_options::no_pattern);
  return here.is_equal(nonzero) ? std::vector<ex>{nonzero} : symbolic::algebra::vanishing_factors(here);
}

bool mentions(const Term& term, const std::string& name) {
  return (term.op() == Op::symbol && term.name() == name) ||
         std::any_of(term.arguments().begin(), term.arguments().end(),
                     [&](const Term& argument) { return mentions(argument, name); });
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
         assumption.statement.left.shape().is_scalar();
}

bool depends_on(const Term& term, const std::string& name) {
  if (mentions(term, name)) {
    return true;
  }
  if (const auto meaning = abbreviated(term)) {
    return depends_on(*meaning, name);
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

std::vector<Statement> statements_of(Prover& prover, const Claim& claim, const Premise& premise) {
  std::vector<Statement> statements;
  if (premise.assumed) {
    statements = {assumption_of(claim, premise.id).statement};
  } else {
    const Record& record = prover.prove(premise.id);
    check_assumptions(prover, claim, record, premise);
    statements = proved_form(record);
  }
  for (Statement& statement : statements) {
    statement = substitute(statement, premise.replacements);
  }
  return statements;
}

void record_premise(Outcome& outcome, Prover& prover, const Claim& claim, const Premise& premise) {
  if (premise.assumed) {
    outcome.assumed.insert(premise.id);
    return;
  }
  outcome.uses.insert(premise.id);
  const Record& record = prover.prove(premise.id);
  for (const std::string& id : final_outcome(record).assumed) {
    if (!premise.supplied.contains(id)) {
      outcome.assumed.insert(id);
    }
  }
  const Given given(claim);
  std::vector<Hypothesis>& here = outcome.inherited[premise.id];
  for (const Hypothesis& general : final_outcome(record).hypotheses) {
    for (const ex& factor : instantiated(general.nonzero, premise, given)) {
      here = joined(here, {hypothesis(factor, general.origin)});
    }
  }
  for (const Assumption& assumption : record.claim.assumptions) {
    if (const auto supplied = premise.supplied.find(assumption.id); supplied != premise.supplied.end()) {
      record_premise(outcome, prover, claim, supplier(premise, supplied->second));
    }
  }
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

namespace {

// The hypothesis that the factor does not vanish, as it reads with the values that the claim gives. Throws
// KernelError where it is zero with these: then the theorem is of nothing.
void record_under_given(Outcome& outcome, const Claim& claim, const ex& factor) {
  GiNaC::exmap values;
  const Given given(claim);
  for (const auto& value : given.values) {
    values[symbolically()(value.first)] = given.lookup()(value.first);
  }
  const ex here = factor.subs(values, GiNaC::subs_options::no_pattern);
  if (here.is_equal(factor)) {
    record_nonzero(outcome, claim, factor);
    return;
  }
  if (here.normal().is_zero()) {
    throw kernel::KernelError("what is divided by is zero where the claim's assumptions hold");
  }
  for (const ex& part : symbolic::algebra::vanishing_factors(here)) {
    record_nonzero(outcome, claim, part);
  }
}

// By the kernel: its theorem, and what that took. False where it refuses.
bool prove_in_kernel(Outcome& outcome, const Claim& claim, const Statement& statement,
                     const std::set<std::string>& open) {
  try {
    const Identity identity = prove_identity(statement, claim.assumptions, open);
    for (const ex& factor : identity.nonzero) {
      record_under_given(outcome, claim, factor);
    }
    outcome.theorems.push_back(identity.theorem);
    outcome.assumed.insert(identity.assumed.begin(), identity.assumed.end());
    outcome.uses.insert(open.begin(), open.end());
    outcome.uses.erase(claim.id);
    return true;
  } catch (const kernel::KernelError&) {
    return false;
  } catch (const NoValue&) {
    return false;
  }
}

}  // namespace

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
  // The older normal form proposes what to open; the kernel proves.
  const symbolic::algebra::Decision proposal =
      symbolic::algebra::decide_equal(left, right, definitions_under(given));
  if (proposal.verdict.truth != Truth::proved ||
      !prove_in_kernel(outcome, claim, statement, proposal.opened)) {
    for (const Term& side : {statement.left, statement.right}) {
      record_assumptions(outcome, claim, side);
    }
    record_decision(outcome, claim, proposal);
  }
  outcome.verdict = proposal.verdict;
  record_free(outcome, left);
  record_free(outcome, right);
  outcome.decided.push_back({statement, left, right, proposal.verdict.truth});
}

}  // namespace stickslip::proofs::methods
