#include "proofs/methods/derivation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/letters.hpp"
#include "proofs/tactics/relations.hpp"

namespace stickslip::proofs::methods {

using namespace kernel;
using namespace tactics;
using symbols::NoValue;

bool occurs(const Term& part, const Term& term) {
  if (part.kind() == kernel::Kind::variable) {
    return term.variables().contains({part.name(), part.type()});
  }
  return !(replaced(term, part, fresh(part.type(), {term, part})) == term);
}

std::set<Term> parts_that(const Term& term, const std::function<bool(const Term&)>& are_so) {
  std::set<Term> result;
  if (are_so(term)) {
    result.insert(term);
  }
  for (const Term& part : term.parts()) {
    result.merge(parts_that(part, are_so));
  }
  return result;
}

namespace {

// About the number of symbols that it takes to write the term down with these definitions opened.
std::size_t opened_size(const Term& term, const Definitions& definitions) {
  std::size_t result = 1;
  for (const Term& part : term.parts()) {
    result += opened_size(part, definitions);
  }
  const bool opened = term.kind() == kernel::Kind::defined && definitions.contains(term.definition());
  return opened ? result + opened_size(term.definition().body(), definitions) : result;
}
constexpr std::size_t longest_looked_into = 30000, longest_of_inequalities = 400;

bool is_zero(const Term& number) {
  const auto seems = attempt([&] { return seems_zero({number}, {}); });
  return seems.value_or(false) && attempt([&] { return Theorem::combination(equal(number, 0)); });
}

}  // namespace

Derivation::Derivation(Prover& prover, const Claim& claim) : prover_(prover), claim_(claim) {
  const auto given = methods::Given::in_both_directions(claim);
  for (const Assumption& assumption : claim.assumptions) {
    try {
      const Formula formula = read_(assumption.statement);
      assumed_.emplace(formula, assumption.id);
      if (is_divisor(formula)) {
        stated_nonzero_.insert(formula);
      }
      if (const auto value = given.value_in(assumption)) {
        const Theorem said = Theorem::assume(formula);
        given_.push_back({assumption.id, given.takes(assumption) ? said : symmetric(said)});
      } else if (is_substitution(assumption)) {
        if (given.values.contains(assumption.statement.left.name())) {  // a second value, and no circle
          given_.push_back({assumption.id, Theorem::assume(formula)});
        }
      } else if (is_inequality(formula)) {
        known_.push_back(Theorem::assume(formula));
      } else if (formula.kind() == kernel::Kind::conjunction && !assumption.statement.during) {
        known_.push_back(part(Theorem::assume(formula), 0));
        known_.push_back(part(Theorem::assume(formula), 1));
      }
    } catch (const NoValue&) {
      continue;
    }
  }
  domain_ = parameters();
  domain_.insert(domain_.end(), known_.begin(), known_.end());
  // From l < x and x < y: l < y.
  const auto is_bound = [](const Theorem& known, const Term& of) {
    return known.conclusion().kind() == kernel::Kind::less && known.conclusion().parts()[1] == of &&
           known.conclusion().parts()[0].kind() == kernel::Kind::number;
  };
  for (std::size_t i = 0; i < domain_.size(); ++i) {
    for (const Theorem& known : known_) {
      if (known.conclusion().kind() != kernel::Kind::less ||
          !is_bound(domain_[i], known.conclusion().parts()[0])) {
        continue;
      }
      const Term& y = known.conclusion().parts()[1];
      if (y.kind() != kernel::Kind::number &&
          std::ranges::none_of(domain_, [&](const Theorem& one) { return is_bound(one, y); })) {
        domain_.push_back(Theorem::order(less(domain_[i].conclusion().parts()[0], y),
                                         {Positive{{domain_[i]}}, Positive{{known}}}));
      }
    }
  }
  for (const Theorem& known : known_) {
    if (known.conclusion().kind() == kernel::Kind::less) {
      const Term gap = gap_of(known.conclusion());
      if (opened_size(gap, openings({known.conclusion()}).in_parameters()) < longest_of_inequalities) {
        know(different(Theorem::order(less(0, gap), {Positive{{known}}})));
      }
    }
  }
  for (const auto& entry : assumed_) {
    if (is_divisor(entry.first)) {
      know(Theorem::assume(entry.first));
    }
  }
  look_at_roots();
}

// Roots of what is positive, by what is known before, are positive.
void Derivation::look_at_roots() {
  for (const Assumption& assumption : claim_.assumptions) {
    const Formula formula = is_of_root(assumption) ? read_(assumption.statement) : at_most(0, 0);
    if (formula.kind() != kernel::Kind::equal) {  // its sign, or a root of an absolute value
      continue;
    }
    const Theorem square = Theorem::assume(formula);
    const Term root = square.conclusion().parts()[0].parts()[0], a = square.conclusion().parts()[1];
    const auto positive = attempt([&] {
      const Theorem squares =
          Theorem::order(less(power(Term(0), 2), power(root, 2)),
                         {Positive{{tactics::inequality(less(0, a), inequalities())}}}, {{square}});
      return below_by_squares(squares, Theorem::assume(at_most(0, root)), 0, root);
    });
    if (positive) {
      known_.push_back(*positive);
      domain_.push_back(*positive);
      know(different(*positive));
    }
  }
}

std::vector<Theorem> Derivation::inequalities() const {
  std::vector<Theorem> result;
  std::ranges::copy_if(domain_, std::back_inserter(result),
                       [](const Theorem& one) { return is_inequality(one.conclusion()); });
  return result;
}

Theorem Derivation::supposing(const Formula& inequality, const std::function<Theorem()>& work) {
  const std::vector<Theorem> known = known_;
  const Domain domain = domain_;
  known_.push_back(Theorem::assume(inequality));
  domain_.push_back(known_.back());
  const auto result = attempt(work);
  known_ = known;
  domain_ = domain;
  return result ? *result : throw KernelError("it does not follow where " + to_string(inequality));
}

Theorem Derivation::without_divisors(const Theorem& theorem) {
  if (divisors_stay_) {
    return theorem;
  }
  const auto open_ones = [this](const Theorem& of) {
    std::vector<Formula> result;
    for (const Formula& one : of.hypotheses()) {
      if (is_divisor(one) && !assumed_.contains(one)) {
        result.push_back(one);
      }
    }
    return result;
  };
  Theorem result = theorem;
  for (const Formula& one : open_ones(theorem)) {
    const Definitions definitions = openings({one}).in_parameters();
    const Formula opened = unfold(one, definitions);
    if (!(opened == one)) {
      result = Theorem::cut(Theorem::convert(Theorem::assume(opened), one, definitions), result);
    }
  }
  result = nonzero(result, domain_, stated_nonzero_);
  if (open_ones(result).empty()) {
    return result;
  }
  look_into_stated();
  for (const Theorem& stated : opened_stated_) {
    if (result.hypotheses().contains(stated.conclusion())) {
      result = Theorem::cut(stated, result);
    }
  }
  result = nonzero(result, domain_, stated_nonzero_);
  if (looks_for_signs_) {
    result = tactics::settled_by(result, [this](const Formula& one) { return differs_by_sign(one); });
  }
  const std::vector<Formula> left = open_ones(result);
  for (const Formula& weak : left) {
    for (const Formula& strong : left) {
      const bool both_stand =
          !(weak == strong) && result.hypotheses().contains(weak) && result.hypotheses().contains(strong);
      const auto implied =
          both_stand ? differs_too(weak.parts()[0].parts()[0], Theorem::assume(strong)) : std::nullopt;
      if (implied) {
        result = Theorem::cut(nonzero(*implied, domain_, {strong}), result);
      }
    }
  }
  return result;
}

std::optional<Theorem> Derivation::differs_by_sign(const Formula& divisor) const {
  if (!is_divisor(divisor) || assumed_.contains(divisor)) {
    return std::nullopt;
  }
  const Term d = divisor.parts()[0].parts()[0];
  const std::vector<Theorem> known = inequalities();
  return tactics::first_that_works(std::array{less(0, d), less(d, 0)}, [&](const Formula& sign) {
    return tactics::different(tactics::inequality(sign, known));
  });
}

// What is stated with its definitions opened, with the given values put in and without, and its factors.
void Derivation::look_into_stated() {
  constexpr std::size_t most = 64;  // "Theta" may be given in two ways, and each by what is given again
  std::vector<Theorem> all = std::exchange(stated_, {});
  for (std::size_t i = 0; i < all.size() && i < most; ++i) {
    const Openings open = openings({all[i].conclusion()});
    const std::size_t length = opened_size(all[i].conclusion(), open.in_parameters());
    const Definitions definitions = length < longest_looked_into ? open.in_parameters() : open.names;
    const Theorem stated = Theorem::convert(all[i], unfold(all[i].conclusion(), definitions), definitions);
    opened_stated_.push_back(stated);
    if (length < longest_looked_into) {
      const std::vector<Theorem> factors = factors_differ(stated);
      domain_.insert(domain_.end(), factors.begin(), factors.end());
    }
    for (const Given& one : given_) {
      if (occurs(one.symbol(), stated.conclusion())) {
        all.push_back(tactics::by_rewriting(stated, one.equation));
      }
    }
  }
}

Definitions Derivation::open(const std::vector<Formula>& formulas) {
  const Openings open = openings(formulas);
  for (const auto& entry : open.closed) {
    uses_.insert(entry.first);
  }
  return open.all();
}

Formulas Derivation::assumed() const {
  Formulas result;
  for (const auto& entry : assumed_) {
    result.insert(entry.first);
  }
  return result;
}

Theorem Derivation::premise(const Premise& premise, std::size_t which) {
  if (premise.assumed) {
    if (!premise.replacements.empty()) {
      throw KernelError("what is assumed is assumed of its own symbols only");
    }
    for (const Assumption& assumption : claim_.assumptions) {
      if (assumption.id == premise.id && which-- == 0) {
        return Theorem::assume(read_(assumption.statement));
      }
    }
    throw KernelError("nothing is assumed as " + premise.id);
  }
  uses_.insert(premise.id);
  const Record& record = prover_.prove(premise.id);
  std::vector<Assumption> supposed = record.claim.assumptions;  // of it, and of what it is supplied with
  for (const auto& [assumption, claim] : premise.supplied) {
    const Record& supply = prover_.prove(claim);
    uses_.insert(claim);
    supposed.insert(supposed.end(), supply.claim.assumptions.begin(), supply.claim.assumptions.end());
    for (const Theorem& theorem : final_outcome(supply).theorems) {
      supplied_.push_back(theorem);
    }
  }
  for (const auto& [assumption, claim] : premise.supplied) {
    if (std::ranges::find(supposed, assumption, &Assumption::id) == supposed.end()) {
      throw KernelError(fmt::format("neither {} nor what is given to it assumes {}", premise.id, assumption));
    }
  }
  const std::vector<symbols::Statement>& form = proved_form(record);
  if (which >= form.size()) {
    throw KernelError(premise.id + " has no such statement");
  }
  const Formula wanted = read_(form[which]);
  for (const Theorem& theorem : final_outcome(record).theorems) {
    if (theorem.conclusion() == wanted) {
      Substitution substitution;
      for (const auto& [name, value] : premise.replacements) {
        substitution.emplace(Variable{name}, read_(value));
      }
      return settled(Theorem::instantiate(theorem, substitution));
    }
  }
  throw KernelError("there is no theorem of " + premise.id);
}

Theorem Derivation::settled(const Theorem& theorem) {
  return without_divisors(settled_by(theorem, [&](const Formula& one) -> std::optional<Theorem> {
    const auto supplier = std::ranges::find(supplied_, one, &Theorem::conclusion);
    if (assumed_.contains(one) || domain_formulas().contains(one) ||
        (is_divisor(one) && supplier == supplied_.end())) {
      return std::nullopt;
    }
    return attempt([&] { return supplier != supplied_.end() ? settled(*supplier) : follows(one); });
  }));
}

Term Derivation::with_values(Term term) const {
  for (std::size_t k = 0; k < given_.size(); ++k) {  // each value may speak of others
    for (const Given& one : given_) {
      term = !one.id.empty() && occurs(one.symbol(), term) ? replaced(term, one.symbol(), one.value()) : term;
    }
  }
  return term;
}

void Derivation::record(Outcome& outcome, const Theorem& theorem, const Formulas& allowed) {
  outcome.uses.insert(uses_.begin(), uses_.end());
  outcome.uses.erase(Openings::coefficients);
  outcome.uses.erase(claim_.id);
  for (const Formula& one : theorem.hypotheses()) {
    if (domain_formulas().contains(one) || allowed.contains(one)) {
      continue;
    }
    if (const auto assumed = assumed_.find(one); assumed != assumed_.end()) {
      outcome.assumed.insert(assumed->second);
      continue;
    }
    if (!is_divisor(one)) {
      throw KernelError("it rests on what the claim does not assume: " + to_string(one));
    }
    const Term here = with_values(one.parts()[0].parts()[0]);
    const Term divisor = unfold(here, openings({here}).in_parameters());
    if (is_zero(divisor)) {
      throw ZeroDivisor("what is divided by is zero where the claim's assumptions hold");
    }
    const Theorem simpler = nonzero(Theorem::assume(differ(divisor, 0)), domain_, stated_nonzero_);
    for (const Formula& factor : simpler.hypotheses()) {
      if (const auto assumed = assumed_.find(factor); assumed != assumed_.end()) {
        outcome.assumed.insert(assumed->second);
      } else if (is_divisor(factor)) {
        outcome.hypotheses =
            joined(outcome.hypotheses, {hypothesis(factor.parts()[0].parts()[0], claim_.id)});
      } else if (!domain_formulas().contains(factor)) {
        throw KernelError("it rests on what the claim does not assume: " + to_string(factor));
      }
    }
  }
}

void Derivation::conclude(Outcome& outcome, const std::vector<Theorem>& theorems) {
  if (theorems.size() != claim_.printed.size()) {
    throw KernelError("not one theorem for each statement");
  }
  for (std::size_t i = 0; i < theorems.size(); ++i) {
    const symbols::Statement& printed = claim_.printed[i];
    if (!(theorems[i].conclusion() == read_(printed))) {
      throw KernelError("a theorem says something else than what is printed");
    }
    const Theorem theorem = settled(theorems[i]);
    if (rests_on_other_roots(theorem, claim_, printed)) {
      throw KernelError("it rests on a root that another statement speaks of");
    }
    record(outcome, theorem);
    outcome.theorems.push_back(theorem);
    record_definitions(outcome, claim_, printed.left);
    record_definitions(outcome, claim_, printed.right);
    for (const Variable& variable : theorem.conclusion().variables()) {
      if (variable.type.is_scalar() && !root_of(variable)) {
        outcome.free.push_back(variable.name);
      }
    }
  }
  std::ranges::sort(outcome.free);
  outcome.free.erase(std::unique(outcome.free.begin(), outcome.free.end()), outcome.free.end());
  outcome.by_kernel = true;
  outcome.verdict = Verdict::proved();
}

std::optional<Theorem> contradiction(Prover& prover, const Claim& claim) {
  Derivation derivation(prover, claim);
  return first_that_works(std::array{less(0, 0), equal(1, 0)}, [&](const Formula& absurd) {
    return derivation.settled(absurd.kind() == kernel::Kind::less ? derivation.follows(absurd)
                                                                  : derivation.combined(absurd));
  });
}

std::optional<std::string> failure_of(const std::function<void()>& work) {
  try {
    work();
    return std::nullopt;
  } catch (const KernelError& error) {
    return error.what();
  } catch (const NoValue& error) {
    return error.what();
  }
}

Outcome derived(const std::string& route, Prover& prover, const Claim& claim, const Derive& derive) {
  Outcome outcome;
  const auto failure = failure_of([&] {
    if (claim.printed.empty()) {
      throw KernelError("it prints nothing that could be proved");
    }
    Derivation derivation(prover, claim);
    std::vector<Theorem> theorems;
    for (std::size_t i = 0; i < claim.printed.size(); ++i) {
      theorems.push_back(derive(derivation, i));
    }
    derivation.conclude(outcome, theorems);
  });
  if (failure) {
    outcome = {};
    outcome.verdict = Verdict::undecided(*failure);
  }
  outcome.route = route;
  return outcome;
}

Proof by_kernel(const std::string& route, const Derive& derive) {
  return [=](Prover& prover, const Claim& claim) { return derived(route, prover, claim, derive); };
}

kernel::Positive not_negative(Derivation& derivation, const Term& a) {
  const Term opened = unfold(a, openings({a}).all());
  const tactics::Letters letters({opened});
  const auto [above, below] = letters.fraction(opened);
  Polynomial product = above;
  product *= below;
  const tactics::Factored whole = tactics::factored(product, letters);
  Rational factor = leading_coefficient(product) / leading_coefficient(whole.product);
  Term square = 1 / letters.term(below);
  std::vector<Theorem> inequalities;
  for (std::size_t k = 0; k < whole.factors.size(); ++k) {
    const Term base = letters.term(whole.factors[k]);
    if (whole.exponents[k] > 1) {
      square = square * power(base, whole.exponents[k] / 2);
    }
    if (whole.exponents[k] % 2 == 1) {
      const auto known = attempt([&] { return derivation.positive(base); });
      inequalities.push_back(known ? *known : derivation.positive(-base));
      factor = known ? factor : Rational(-factor);
    }
  }
  if (factor < 0) {
    throw KernelError("no sign is known of " + to_string(a));
  }
  return {inequalities, factor, square};
}

Definitions Openings::all() const {
  Definitions result = with({});
  for (const auto& entry : closed) {
    result.insert(entry.second.begin(), entry.second.end());
  }
  return result;
}

Definitions Openings::in_parameters() const {
  Openings less = *this;
  less.closed.erase(coefficients);
  return less.all();
}

Definitions Openings::with(const std::set<std::string>& ids) const {
  Definitions result = names;
  result.insert(formulas.begin(), formulas.end());
  for (const auto& entry : closed) {
    if (ids.contains(entry.first)) {
      result.insert(entry.second.begin(), entry.second.end());
    }
  }
  return result;
}

namespace {

void add(Openings& openings, const Definition& definition) {
  const kernel::Type& type = definition.body().type();
  const symbols::Symbols& table = symbols::symbol_table();
  const auto row = std::ranges::find_if(table, [&](const symbols::Symbol& one) {
    return one.name == definition.name() && one.shape == symbols::Shape{type.rows, type.columns};
  });
  const bool has_row = row != table.end();
  if (has_row && row->value) {
    openings.names.insert(definition);
  } else if (!type.is_scalar()) {
    openings.formulas.insert(definition);
  } else {
    const std::string id = has_row && row->means                 ? Openings::coefficients
                           : has_row && !row->formula_in.empty() ? row->formula_in
                                                                 : "39";
    openings.closed[id].insert(definition);
  }
}

}  // namespace

Openings openings(const std::vector<Formula>& formulas) {
  Openings result;
  for (const Definition& definition : tactics::definitions_in(formulas)) {
    add(result, definition);
  }
  return result;
}

}  // namespace stickslip::proofs::methods
