#include "proofs/methods/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::methods {

using namespace symbols;

namespace {

const Assumption& assumption_of(const Claim& claim, const std::string& id) {
  const auto found = std::ranges::find_if(claim.assumptions,
                                          [&](const Assumption& assumption) { return assumption.id == id; });
  if (found == claim.assumptions.end()) {
    throw InternalError(fmt::format("claim {} does not assume {}", claim.id, id));
  }
  return *found;
}

// All that is divided by in the term, or below the bar of a tangent.
std::vector<Term> divisors_in(const Term& term) {
  std::vector<Term> all;
  const std::vector<Term>& parts = term.arguments();
  if (term.op() == Op::quotient) {
    all.push_back(parts.at(1));
  } else if (term.op() == Op::power && term.number() < 0) {
    all.push_back(term.shape().is_scalar() ? parts.at(0) : determinant(parts.at(0)));
  } else if (term.op() == Op::function && term.name() == "tan") {
    all.push_back(cos(parts.at(0)));
  }
  for (const Term& part : parts) {
    const std::vector<Term> deeper = divisors_in(part);
    all.insert(all.end(), deeper.begin(), deeper.end());
  }
  return all;
}

// Adds the roots within the term, those within one of them first.
void add_roots(const Term& term, std::vector<Term>& roots, std::set<std::string>& seen) {
  for (const Term& part : term.arguments()) {
    add_roots(part, roots, seen);
  }
  if (term.op() != Op::symbol && term.op() != Op::function) {
    return;
  }
  if (term.name() == "sqrt") {
    if (std::ranges::none_of(roots, [&](const Term& one) { return equal(one, term); })) {
      roots.push_back(term);
    }
    return;
  }
  const Symbol * row = symbol_table().find(term);
  if (row == nullptr || !(row->value || row->means)) {
    return;
  }
  const Term means = row->value ? *row->value : *row->means;
  if (row->of_time) {
    add_roots(substitute(means, {{"t", term.arguments().front()}}), roots, seen);
  } else if (seen.insert(term.name()).second) {
    add_roots(means, roots, seen);
  }
}

// b = a, of a = b.
Assumption turned_round(Assumption assumption) {
  if (!assumption.statement.during) {
    std::swap(assumption.statement.left, assumption.statement.right);
  }
  return assumption;
}

}  // namespace

bool is_of_root(const Assumption& assumption) {
  return assumption.id.starts_with("sqrt(");  // what is named is named by a word
}

Claim saying(Claim claim, std::vector<Statement> statements) {
  std::erase_if(claim.assumptions, is_of_root);
  claim.printed = std::move(statements);
  std::vector<Statement> said = claim.printed;
  for (const Assumption& one : claim.assumptions) {
    said.push_back(one.statement);
  }
  std::vector<Term> roots;
  std::set<std::string> seen;
  for (const Statement& one : said) {
    for (const Term& side : {one.left, one.right}) {
      add_roots(side, roots, seen);
    }
    if (one.during) {
      add_roots(one.during->from, roots, seen);
      add_roots(one.during->to, roots, seen);
    }
  }
  for (const Term& root : roots) {
    const std::string id = text(root);
    claim.assumptions.push_back({id + ", squared", equation(power(root, 2), root.arguments().front())});
    claim.assumptions.push_back({id + ", its sign", {root, 0, Relation::greater_or_equal}});
  }
  return claim;
}

bool rests_on_other_roots(const kernel::Theorem& theorem, const Claim& claim, const Statement& statement) {
  Reader read;
  const auto roots_of = [&](const Claim& one) {
    kernel::Formulas formulas;
    for (const Assumption& assumption : one.assumptions) {
      if (is_of_root(assumption)) {
        formulas.insert(read(assumption.statement));
      }
    }
    return formulas;
  };
  const kernel::Formulas all = roots_of(claim),
                         own = all.empty() ? all : roots_of(saying(claim, {statement}));
  return std::ranges::any_of(theorem.hypotheses(), [&](const kernel::Formula& one) {
    return all.contains(one) && !own.contains(one);
  });
}

bool is_substitution(const Assumption& assumption) {
  return assumption.statement.relation == Relation::equal && assumption.statement.left.op() == Op::symbol &&
         assumption.statement.left.shape().is_scalar() &&
         assumption.statement.left.name() != symbols::pi().name() &&  // which has its value
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
      take(assumption.statement);
    }
  }
}

// First those that can be read in one direction only, and that is not the usual one.
Given Given::in_both_directions(const Claim& claim) {
  if (!claim.is_searched) {
    return Given(claim);
  }
  Given result;
  const auto take = [&](const Assumption& one) {
    if (is_substitution(one)) {
      result.take(one.statement);
    }
  };
  for (const Assumption& one : claim.assumptions) {
    if (!is_substitution(one)) {
      take(turned_round(one));
    }
  }
  std::ranges::for_each(claim.assumptions, take);
  for (const Assumption& one : claim.assumptions) {
    if (!result.takes(one)) {
      take(turned_round(one));
    }
  }
  return result;
}

bool Given::take(const Statement& statement) {
  return !leads_to(statement.right, statement.left.name()) &&
         values.emplace(statement.left.name(), statement.right).second;
}

bool Given::takes(const Assumption& assumption) const {
  const auto value =
      is_substitution(assumption) ? values.find(assumption.statement.left.name()) : values.end();
  return value != values.end() && equal(value->second, assumption.statement.right);
}

std::optional<Statement> Given::value_in(const Assumption& assumption) const {
  const Assumption turned = turned_round(assumption);
  return takes(assumption) ? std::optional(assumption.statement)
         : takes(turned)   ? std::optional(turned.statement)
                           : std::nullopt;
}

bool Given::leads_to(const Term& term, const std::string& name) const {
  const std::set<std::string> names = names_in(term);
  return names.contains(name) || std::ranges::any_of(names, [&](const std::string& one) {
           const auto value = values.find(one);
           return value != values.end() && leads_to(value->second, name);
         });
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

void record_definitions(Outcome& outcome, const Claim& claim, const Term& term) {
  for (const std::string& id : definitions_in(term)) {
    if (id != claim.id) {
      outcome.uses.insert(id);
    }
  }
}

namespace {

// Whether d is zero where f is, by what the claim assumes of roots: x - 1 where sqrt(x) - 1 is.
bool vanish_together(const kernel::Term& d, const kernel::Term& f, const Claim& claim) {
  Reader read;
  std::vector<kernel::Theorem> zero{kernel::Theorem::assume(kernel::equal(f, 0))};
  for (const Assumption& one : claim.assumptions) {
    if (is_of_root(one) && one.statement.relation == Relation::equal) {
      zero.push_back(kernel::Theorem::assume(read(one.statement)));
    }
  }
  const auto found = tactics::attempt([&] {
    std::vector<kernel::Term> gaps;
    std::ranges::transform(zero, std::back_inserter(gaps),
                           [](const kernel::Theorem& one) { return -gap_of(one.conclusion()); });
    const auto factors = zero.size() > 1 ? tactics::multipliers(d, gaps) : std::nullopt;
    std::vector<kernel::Multiple> multiples;
    for (std::size_t k = 0; factors && k < zero.size(); ++k) {
      multiples.push_back({zero[k], (*factors)[k]});
    }
    return kernel::Theorem::combination(kernel::equal(d, 0), multiples);
  });
  return found.has_value();
}

}  // namespace

bool is_seen(const Hypothesis& hypothesis, const Claim& needing, const Claim& origin) {
  if (origin.id != needing.id && facts(origin.origin).source == nullptr) {
    return false;
  }
  Reader read;
  const auto opened = [&](const Term& term) {
    const kernel::Term made = read(term);
    return unfold(made, openings({made}).in_parameters());
  };
  const kernel::Term needed = opened(hypothesis.nonzero);
  for (const Statement& one : origin.printed) {
    for (const Term& side : {one.left, one.right}) {
      for (const Term& divisor : divisors_in(side)) {
        if (is_in_field(divisor) && (tactics::implies_nonzero(opened(divisor), needed, parameters()) ||
                                     vanish_together(opened(divisor), needed, origin))) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace stickslip::proofs::methods
