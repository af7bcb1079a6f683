#include <algorithm>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {

Theorem::Theorem(Step step, Formulas hypotheses, const Formula& conclusion)
    : data_(std::make_shared<const Data>(
          Data{{std::move(hypotheses), conclusion}, std::make_shared<const Step>(std::move(step))})) {
  std::map<std::string, Type> types;
  const auto check = [&](const Formula& formula) {
    require(formula.type() == truth_value && formula.is_closed(), "a sequent is made of closed formulas");
    for (const Variable& variable : formula.variables()) {
      require(types.emplace(variable.name, variable.type).first->second == variable.type,
              "the name " + variable.name + " stands for variables of two types");
    }
  };
  std::for_each(this->hypotheses().begin(), this->hypotheses().end(), check);
  check(conclusion);
}

namespace {

Formulas hypotheses_of(const Step& step) {
  Formulas all = step.divisors;
  for (const Theorem& premise : step.premises) {
    all.insert(premise.hypotheses().begin(), premise.hypotheses().end());
  }
  return all;
}

Formulas without(Formulas formulas, const Formula& one) {
  formulas.erase(one);
  return formulas;
}

bool is_free_in(const Variable& variable, const Formulas& formulas) {
  return std::any_of(formulas.begin(), formulas.end(),
                     [&](const Formula& formula) { return formula.variables().contains(variable); });
}

// Truth tables by cases, with the values of the atoms decided so far.
class Tables {
 public:
  explicit Tables(std::vector<Formula> premises, const Formula& conclusion)
      : premises_(std::move(premises)), conclusion_(conclusion) {}

  bool closes() {
    require(++cases_ <= 100000, "too many cases of truth and falsity");
    open_.reset();
    for (const Formula& premise : premises_) {
      const std::optional<bool> truth = value(premise);
      if (truth && !*truth) {
        return true;
      }
    }
    const std::optional<bool> truth = value(conclusion_);
    if (truth && *truth) {
      return true;
    }
    if (!open_) {
      return false;  // all is decided: premises true, conclusion false
    }
    const Formula atom = *open_;
    for (const bool choice : {true, false}) {
      values_.insert_or_assign(atom, choice);
      if (!closes()) {
        return false;
      }
    }
    values_.erase(atom);
    return true;
  }

 private:
  std::optional<bool> value(const Formula& formula) {
    const std::vector<Formula>& parts = formula.parts();
    switch (formula.kind()) {
      case Kind::negation: {
        const std::optional<bool> truth = value(parts[0]);
        return truth ? std::optional(!*truth) : truth;
      }
      case Kind::implication: {
        const std::optional<bool> from = value(parts[0]), to = value(parts[1]);
        if ((from && !*from) || (to && *to)) {
          return true;
        }
        return from && to ? std::optional(false) : std::nullopt;
      }
      case Kind::conjunction:
      case Kind::disjunction: {
        const bool decisive = formula.kind() == Kind::disjunction;  // what one part settles
        bool all_known = true;
        for (const Formula& part : parts) {
          const std::optional<bool> truth = value(part);
          if (truth && *truth == decisive) {
            return decisive;
          }
          all_known = all_known && truth.has_value();
        }
        return all_known ? std::optional(!decisive) : std::nullopt;
      }
      default: {
        const auto found = values_.find(formula);
        if (found != values_.end()) {
          return found->second;
        }
        open_ = open_ ? open_ : std::optional(formula);
        return std::nullopt;
      }
    }
  }

  std::vector<Formula> premises_;
  Formula conclusion_;
  std::map<Formula, bool, Before> values_;
  std::optional<Formula> open_;  // an atom without value that was met
  long cases_ = 0;
};

}  // namespace

Theorem::Theorem(const Step& step, const Formula& conclusion)
    : Theorem(step, hypotheses_of(step), conclusion) {}

Theorem Theorem::assume(const Formula& a) {
  return {{.rule = "assume", .data = {a}}, {a}, a};
}

Theorem Theorem::discharge(const Theorem& theorem, const Formula& a) {
  return {{.rule = "discharge", .premises = {theorem}, .data = {a}},
          without(theorem.hypotheses(), a),
          implies(a, theorem.conclusion())};
}

Theorem Theorem::cut(const Theorem& lemma, const Theorem& theorem) {
  Formulas hypotheses = without(theorem.hypotheses(), lemma.conclusion());
  hypotheses.insert(lemma.hypotheses().begin(), lemma.hypotheses().end());
  return {{.rule = "cut", .premises = {lemma, theorem}}, hypotheses, theorem.conclusion()};
}

Theorem Theorem::consequence(const std::vector<Theorem>& premises, const Formula& conclusion) {
  require(conclusion.type() == truth_value, "a conclusion is a formula");
  std::vector<Formula> formulas;
  for (const Theorem& premise : premises) {
    formulas.push_back(premise.conclusion());
  }
  require(Tables(formulas, conclusion).closes(), "the conclusion does not follow by truth tables");
  return {{.rule = "consequence", .premises = premises}, conclusion};
}

Theorem Theorem::instantiate(const Theorem& theorem, const Substitution& substitution) {
  Step step{.rule = "instantiate", .premises = {theorem}};
  for (const auto& [variable, value] : substitution) {
    step.data.emplace_back(variable);
    step.data.push_back(value);
  }
  Formulas hypotheses;
  for (const Formula& hypothesis : theorem.hypotheses()) {
    hypotheses.insert(substitute(hypothesis, substitution));
  }
  return {step, hypotheses, substitute(theorem.conclusion(), substitution)};
}

Theorem Theorem::generalize(const Theorem& theorem, const Variable& variable) {
  require(!is_free_in(variable, theorem.hypotheses()),
          "the variable " + variable.name + " is in a hypothesis");
  return {{.rule = "generalize", .premises = {theorem}, .data = {variable}},
          for_all(variable, theorem.conclusion())};
}

Theorem Theorem::specialize(const Theorem& theorem, const Term& term) {
  require(theorem.conclusion().kind() == Kind::for_all, "only what is so for all is so for one");
  return {{.rule = "specialize", .premises = {theorem}, .data = {term}}, opened(theorem.conclusion(), term)};
}

Theorem Theorem::witness(const Theorem& theorem, const Formula& existence, const Term& term) {
  require(existence.kind() == Kind::exists && opened(existence, term) == theorem.conclusion(),
          "the theorem does not say this of the witness");
  return {{.rule = "witness", .premises = {theorem}, .data = {existence, term}}, existence};
}

Theorem Theorem::choose(const Theorem& existence, const Variable& variable, const Theorem& theorem) {
  const Formula& claim = existence.conclusion();
  require(claim.kind() == Kind::exists && claim.binds() == variable.type,
          "one chooses what there is, of its own type");
  Formulas hypotheses = without(theorem.hypotheses(), opened(claim, variable));
  require(!is_free_in(variable, hypotheses) && !theorem.conclusion().variables().contains(variable) &&
              !claim.variables().contains(variable),
          "the variable chosen is used elsewhere");
  hypotheses.insert(existence.hypotheses().begin(), existence.hypotheses().end());
  return {{.rule = "choose", .premises = {existence, theorem}, .data = {variable}},
          hypotheses,
          theorem.conclusion()};
}

Theorem Theorem::reflexive(const Term& a) {
  return {{.rule = "reflexive", .data = {a}}, equal(a, a)};
}

Theorem Theorem::replace(const Theorem& equation, const Variable& place, const Formula& formula,
                         const Theorem& theorem) {
  const auto [a, b] = sides(equation, Kind::equal);
  require(substitute(formula, {{place, a}}) == theorem.conclusion(),
          "the theorem is not the formula with the equation's left side in place");
  return {{.rule = "replace", .premises = {equation, theorem}, .data = {place, formula}},
          substitute(formula, {{place, b}})};
}

Theorem Theorem::convert(const Theorem& theorem, const Formula& conclusion, const Definitions& definitions) {
  require(unfold(theorem.conclusion(), definitions) == unfold(conclusion, definitions),
          "the two differ when the definitions are unfolded");
  return {{.rule = "convert", .premises = {theorem}, .data = {conclusion}, .unfolded = definitions},
          conclusion};
}

}  // namespace stickslip::proofs::kernel
