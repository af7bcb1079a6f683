#include "proofs/checks/premises.hpp"

#include <algorithm>

#include "proofs/methods/assumptions.hpp"
#include "proofs/symbols/sample.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::checks {

using namespace methods;
using namespace symbols;

namespace {

bool is_frequency(const std::string& name) {
  return vocabulary_here().is_of_model() && (name == "omega1" || name == "omega2");
}

bool is_solved_for(const std::string& name) {
  return std::ranges::find(solved_for(), name) != solved_for().end();
}

// A name whose value may be put in: no unknown, nothing that the model's formulas are made of or give.
bool is_name(const Term& term) {
  static const std::vector<std::string> parameters{"omega", "omega1", "omega2", "p"};
  const bool is_given =
      vocabulary_here().is_of_model() && std::ranges::find(parameters, term.name()) != parameters.end();
  return stands_for_itself(term) && !is_solved_for(term.name()) && !is_given;
}

// Whether it is made of what has a value and of the motion Z.
bool in_terms_of_Z(const Term& term) {
  return (vocabulary_here().is_of_model() && term.op() == Op::function && term.name() == "Z") ||
         is_in_field(term) ||
         (!term.arguments().empty() && term.op() != Op::function &&
          std::ranges::all_of(term.arguments(), in_terms_of_Z));
}

// The term with the motions put in.
Term with_motions(const Premises& premises, const Term& term) {
  std::vector<Term> arguments;
  for (const Term& argument : term.arguments()) {
    arguments.push_back(with_motions(premises, argument));
  }
  const auto& motions = premises.motions;
  const auto motion = term.op() == Op::function ? motions.find(term.name()) : motions.end();
  if (motion != motions.end()) {
    return substitute(with_motions(premises, motion->second), {{"t", arguments.front()}});
  }
  return arguments.empty() ? term : term.with_arguments(std::move(arguments));
}

void add_value(Premises& premises, const Statement& statement) {
  if (premises.reached(statement.right).contains(statement.left.name())) {
    premises.equations.push_back(statement);
    return;
  }
  const auto [known, fresh] = premises.values.emplace(statement.left.name(), statement.right);
  if (!fresh && !equal(known->second, statement.right)) {
    premises.equations.push_back(statement);
  }
}

bool is_ratio(const std::string& name) {
  return vocabulary_here().is_of_model() && (name == "chi" || name == "eta");
}

// Whether the claim gives both of chi and eta in terms of what stands for itself, and no frequency: these
// follow then.
bool gives_ratios(const Claim& claim) {
  std::set<std::string> given;
  for (const Assumption& assumption : claim.assumptions) {
    const std::string& name = assumption.statement.left.name();
    if (is_substitution(assumption) && (is_ratio(name) || is_frequency(name))) {
      const std::set<std::string> names = names_in(assumption.statement.right);
      const bool plain = !is_frequency(name) && std::ranges::all_of(names, [](const std::string& one) {
        return !is_frequency(one) && stands_for_itself(scalar(one));
      });
      if (!plain) {
        return false;
      }
      given.insert(name);
    }
  }
  return given.size() == 2;
}

void add(Premises& premises, const Statement& statement) {
  const Term& left = statement.left;
  const bool equation = statement.relation == Relation::equal;
  const bool of_time =
      left.op() == Op::function && left.arguments().front().op() == Op::symbol &&
      left.arguments().front().name() == "t" && !is_in_field(left) &&
      (left.name() == "Z" && vocabulary_here().is_of_model() ? is_in_field(statement.right)
                                                             : in_terms_of_Z(statement.right));
  if (equation && of_time) {
    const auto [known, fresh] = premises.motions.emplace(left.name(), statement.right);
    premises.consistent = premises.consistent && (fresh || equal(known->second, statement.right));
  } else if (equation && is_name(left)) {
    add_value(premises, statement);
  } else {
    (equation ? premises.equations : premises.inequalities).push_back(statement);
  }
}

// Puts the motions in, and sorts out what has no value.
void finish(Premises& premises, std::vector<Statement>& statements) {
  const auto evaluable = [](const Term& term) {
    return is_in_field(term.name() == "abs" ? term.arguments().front() : term);
  };
  std::vector<Statement> kept;
  for (const Statement& statement : statements) {
    const Statement meant = premises.with_motions(statement);
    (evaluable(meant.left) && evaluable(meant.right) ? kept : premises.left_out).push_back(meant);
  }
  statements = std::move(kept);
}

}  // namespace

bool stands_for_itself(const Term& term) {
  const Lookup<Ball> one = [](const std::string&) { return Ball(1); };
  return term.op() == Op::symbol && term.shape().is_scalar() && term.name() != pi().name() &&
         !abbreviated(term) && !derived<Ball>(term.name(), one);
}

// The states first: they are solved for before what the friction does.
const std::vector<std::string>& solved_for() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const char * where : {"C", "B", "0"}) {
      for (const char * what : {"z1", "z2", "zdot1", "zdot2"}) {
        result.push_back(std::string(what) + where);
      }
    }
    for (int i = 1; i <= 5; ++i) {
      result.push_back(coefficient('d', i).name());
    }
    result.insert(result.end(), {"xddot1", "xddot2", "V", "ur", "us", "u"});
    return result;
  }();
  return names;
}

Statement Premises::with_motions(const Statement& statement) const {
  return {checks::with_motions(*this, statement.left), checks::with_motions(*this, statement.right),
          statement.relation, statement.during};
}

std::set<std::string> Premises::reached(const Term& term) const {
  std::set<std::string> result;
  std::vector<std::set<std::string>> layers{names_in(term)};
  while (!layers.empty()) {
    const std::set<std::string> names = std::move(layers.back());
    layers.pop_back();
    for (const std::string& name : names) {
      const auto value = result.insert(name).second ? values.find(name) : values.end();
      if (value != values.end()) {
        layers.push_back(names_in(value->second));
      }
    }
  }
  return result;
}

std::optional<Premises> Premises::with(const Replacements& further) const {
  Premises result = *this;
  for (const auto& [name, value] : further) {
    if (values.contains(name) || reached(value).contains(name)) {
      return std::nullopt;
    }
    result.values.emplace(name, value);
  }
  return result;
}

Premises premises_of(Prover& prover, const Claim& claim, const Outcome& outcome) {
  Premises result;
  result.hypotheses = outcome.hypotheses;
  const bool by_ratios = gives_ratios(claim);
  for (const Assumption& assumption : claim.assumptions) {
    const Term& left = assumption.statement.left;
    if (is_of_root(assumption) && assumption.statement.relation == Relation::equal) {
      continue;  // true of numbers, and nothing is solved by it
    }
    const bool is_value = is_substitution(assumption) && !is_solved_for(left.name()) &&
                          (stands_for_itself(left) || (by_ratios && is_ratio(left.name())));
    is_value ? add_value(result, assumption.statement) : add(result, assumption.statement);
  }
  for (const std::string& used : outcome.uses) {
    const Record& premise = prover.prove(used);
    const Outcome& proved = final_outcome(premise);
    if (!proved.cross_check.identity) {
      for (const Statement& statement : proved_form(premise)) {
        add(result, statement);
      }
    }
  }
  finish(result, result.equations);
  finish(result, result.inequalities);
  return result;
}

}  // namespace stickslip::proofs::checks
