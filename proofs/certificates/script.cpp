#include "proofs/certificates/script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// Steps that are written where they are used, however often.
bool is_a_word(const std::string& rule) {
  return rule == "assume" || rule == "reflexive" || rule == "trichotomy" || rule == "zero_product" ||
         rule == "sine_is_positive" || rule == "square_root";
}

// Steps that are a term rather than tactics.
bool is_a_term(const std::string& rule) {
  return is_a_word(rule) || rule == "discharge" || rule == "cut" || rule == "generalize" ||
         rule == "specialize" || rule == "replace";
}

// Proved in a few steps, none of which needs interval arithmetic.
bool is_short(const Theorem& theorem) {
  constexpr int few = 12;
  int steps = 0;
  const auto visit = [&](const auto& self, const Theorem& one) -> bool {
    const Step& step = one.derivation();
    return ++steps <= few && step.rule != "sign" && step.rule != "jury" && step.rule != "one_zero" &&
           std::ranges::all_of(step.premises, [&](const Theorem& premise) { return self(self, premise); });
  };
  return visit(visit, theorem);
}

// The term with values for variables that nothing around binds: what is so for all is so for these.
Term within_scope(const Term& term, const Variables& variables) {
  Substitution values;
  for (const Variable& variable : term.variables()) {
    if (!variables.contains(variable)) {
      const Type& type = variable.type;
      const Term nothing = zero(real_matrix(type.rows, type.columns));
      values.emplace(variable, type.sort == Sort::function ? lambda({"t", real_number}, nothing) : nothing);
    }
  }
  return values.empty() ? term : substitute(term, values);
}

}  // namespace

const Lemma * Library::find(const Theorem& theorem) const {
  const auto found = lemmas.find({theorem.hypotheses(), theorem.conclusion()});
  return found == lemmas.end() ? nullptr : &found->second;
}

void Library::erase(const std::string& file) {
  const auto of_file = [&](const auto& lemma) { return lemma.second.file == file; };
  std::erase_if(lemmas, of_file);
  std::erase_if(tautologies, of_file);
}

void Script::count(const Theorem& theorem) {
  if (known(theorem) == nullptr && uses_[&theorem.derivation()]++ == 0) {
    for (const Theorem& premise : theorem.derivation().premises) {
      count(premise);
    }
  }
}

void Script::add(const std::string& name, const Theorem& theorem, const std::string& comment) {
  library_.alive.push_back(theorem);
  count(theorem);
  Lemma claim{.file = file_, .name = name, .stated = {}};
  state(comment.empty() ? "Theorem" : "(* " + comment + " *)\nTheorem", claim, theorem);
}

// Puts the lemmas that it needs before it.
void Script::state(const std::string& word, const Lemma& name, const Theorem& theorem) {
  Lemma lemma = name;
  lemma.stated = word == "Lemma" ? stated(theorem, [&](const Formula& formula) { return said(formula); })
                                 : stated(theorem);
  collect_definitions(theorem, definitions_);
  Scope scope{.hypotheses = {}, .variables = {}};
  std::string names;
  for (const Variable& variable : lemma.stated.variables) {
    scope.variables.insert(variable);
    names += " " + identifier(variable.name);
  }
  for (const Formula& formula : lemma.stated.hypotheses) {
    const std::string label = "hyp" + std::to_string(scope.hypotheses.size() + 1);
    scope.hypotheses.emplace(formula, label);
    names += " " + label;
  }
  const bool again = word != "Lemma" && known(theorem) != nullptr;
  const std::string proof =
      again || is_a_term(theorem.derivation().rule)
          ? fmt::format("exact {}.", again ? term(theorem, scope) : inlined(theorem, scope))
          : tactics(theorem, scope);
  text_ += fmt::format("{} {} :\n{}.\nProof.\n{}{}\nQed.\n\n", word, lemma.name, lemma.stated.text,
                       names.empty() ? "" : fmt::format("intros{}.\n", names), proof);
  library_.lemmas.insert_or_assign(std::pair{theorem.hypotheses(), theorem.conclusion()}, std::move(lemma));
}

const Lemma& Script::imported(const Lemma& lemma) {
  if (lemma.file != file_) {
    imports_.insert(lemma.file);
  }
  return lemma;
}

bool Script::is_slow(const std::string& file) const {
  return file != file_ && !imports_.contains(file) && library_.slow.contains(file);
}

const Lemma * Script::known(const Theorem& theorem) const {
  const Lemma * found = library_.find(theorem);
  return found != nullptr && is_slow(found->file) && is_short(theorem) ? nullptr : found;
}

const Lemma& Script::lemma(const Theorem& theorem) {
  if (known(theorem) == nullptr) {
    state("Lemma", {.file = file_, .name = fresh(file_ + "_step"), .stated = {}}, theorem);
  }
  return imported(*library_.find(theorem));
}

std::string Script::applied(const Lemma& lemma, const Scope& scope, const Substitution& values) const {
  if (lemma.stated.variables.empty() && lemma.stated.hypotheses.empty()) {
    return lemma.name;
  }
  std::string call = "(" + lemma.name;
  for (const Variable& variable : lemma.stated.variables) {
    const auto value = values.find(variable);
    if (value != values.end()) {
      call += " " + coq(value->second);
    } else {
      call +=
          " " + (scope.variables.contains(variable) ? identifier(variable.name) : any_value(variable.type));
    }
  }
  for (const Formula& hypothesis : lemma.stated.hypotheses) {
    call += " " + this->hypothesis(substitute(hypothesis, values), scope);
  }
  return call + ")";
}

std::string Script::hypothesis(const Formula& formula, const Scope& scope) const {
  const auto found = scope.hypotheses.find(formula);
  if (found == scope.hypotheses.end()) {
    throw KernelError("no hypothesis says " + to_string(formula));
  }
  return found->second;
}

std::string Script::said(const Formula& formula) {
  const std::string text = coq_premise(formula);
  if (formula.kind() != Kind::conjunction || text.size() < 300) {
    return text;
  }
  const std::vector<Variable> variables(formula.variables().begin(), formula.variables().end());
  const auto [name, is_new] = names_.emplace(formula, "");
  if (is_new) {
    name->second = fresh(file_ + "_said");
    text_ += fmt::format("Definition {}{} : Prop :=\n  {}.\n\n", name->second,
                         variables.empty() ? "" : " " + binders(variables), text);
  }
  std::string call = name->second;
  for (const Variable& variable : variables) {
    call += " " + identifier(variable.name);
  }
  return call;
}

std::string Script::term(const Theorem& theorem, const Scope& scope) {
  const std::string& rule = theorem.derivation().rule;
  const bool once = is_a_term(rule) && rule != "replace" && is_used_here_only(theorem);
  return is_a_word(rule) || once ? inlined(theorem, scope) : applied(lemma(theorem), scope);
}

bool Script::is_used_here_only(const Theorem& theorem) {
  return uses_[&theorem.derivation()] <= 1 && known(theorem) == nullptr;
}

std::string Script::inlined(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const auto with = [&](const Formula& formula, const std::string& name) {
    Scope inside = scope;
    inside.hypotheses.insert_or_assign(formula, name);
    return inside;
  };
  if (step.rule == "assume") {
    return hypothesis(step.data[0], scope);
  }
  if (step.rule == "reflexive") {
    return fmt::format("(eq_refl {})", coq(within_scope(step.data[0], scope.variables)));
  }
  if (step.rule == "trichotomy" || step.rule == "zero_product") {
    return fmt::format("({} {} {})", step.rule, coq(within_scope(step.data[0], scope.variables)),
                       coq(within_scope(step.data[1], scope.variables)));
  }
  if (step.rule == "sine_is_positive" || step.rule == "square_root") {
    return fmt::format("({} {})", step.rule, coq(within_scope(step.data[0], scope.variables)));
  }
  if (step.rule == "discharge") {
    const std::string name = fresh("by");
    return fmt::format("(fun {} : {} => {})", name, said(within_scope(step.data[0], scope.variables)),
                       term(step.premises[0], with(step.data[0], name)));
  }
  if (step.rule == "cut") {
    const Formula& known = step.premises[0].conclusion();
    if (!step.premises[1].hypotheses().contains(known)) {
      return term(step.premises[1], scope);
    }
    const std::string proof = term(step.premises[0], scope);
    if (proof.size() < 60) {
      return term(step.premises[1], with(known, proof));
    }
    const std::string name = fresh("by");
    return fmt::format("(let {} := {} in {})", name, proof, term(step.premises[1], with(known, name)));
  }
  if (step.rule == "generalize") {
    Scope inside = scope;
    const Term& variable = step.data[0];
    inside.variables.insert({variable.name(), variable.type()});
    return fmt::format("(fun {} => {})", binders({{variable.name(), variable.type()}}),
                       term(step.premises[0], inside));
  }
  if (step.rule == "specialize") {
    return fmt::format("({} {})", term(step.premises[0], scope),
                       coq(within_scope(step.data[0], scope.variables)));
  }
  if (step.rule == "replace") {
    const Theorem& equation = step.premises[0];
    const Term& place = step.data[0];
    const std::string numbers = coq_type(place.type());
    return fmt::format("(@eq_ind ({}) {} (fun {} : {} => {}) {} {} {})", numbers,
                       coq(equation.conclusion().parts()[0]), identifier(place.name()), numbers,
                       coq(step.data[1]), term(step.premises[1], scope),
                       coq(equation.conclusion().parts()[1]), term(equation, scope));
  }
  return applied(lemma(theorem), scope);
}

// There is x, and y, …: all values at once, so that what is said of them is not read once for each.
std::string Script::witness(const Theorem& theorem, const Scope& scope) {
  std::string values, ends;
  Theorem rest = theorem;
  do {
    const Step& step = rest.derivation();
    values += fmt::format("(ex_intro _ {} ", coq(within_scope(step.data[1], scope.variables)));
    ends += ")";
    rest = Theorem(step.premises[0]);
  } while (rest.derivation().rule == "witness" && is_used_here_only(rest));
  const bool follows = is_used_here_only(rest) && !is_a_term(rest.derivation().rule) &&
                       std::ranges::includes(scope.variables, rest.conclusion().variables());
  return follows ? fmt::format("refine {}_{}.\n{}", values, ends, tactics(rest, scope))
                 : fmt::format("exact {}{}{}.", values, term(rest, scope), ends);
}

std::string Script::tactics(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (step.rule == "combination") {
    return combination(theorem, scope);
  }
  if (step.rule == "order") {
    return order(theorem, scope);
  }
  if (step.rule == "consequence") {
    return consequence(theorem, scope);
  }
  if (step.rule == "sign") {
    return sign(theorem);
  }
  if (step.rule == "jury") {
    return jury(theorem);
  }
  if (step.rule == "one_zero") {
    return one_zero(theorem);
  }
  if (step.rule == "instantiate") {
    Substitution values;
    for (std::size_t i = 0; i + 1 < step.data.size(); i += 2) {
      values.emplace(Variable{step.data[i].name(), step.data[i].type()}, step.data[i + 1]);
    }
    return fmt::format("exact {}.", applied(lemma(step.premises[0]), scope, values));
  }
  if (step.rule == "convert") {
    return fmt::format("exact {}.", term(step.premises[0], scope));
  }
  if (step.rule == "witness") {
    return witness(theorem, scope);
  }
  if (step.rule == "choose") {
    const Variable variable{step.data[0].name(), step.data[0].type()};
    const std::string name = fresh("by");
    Scope inside = scope;
    inside.variables.insert(variable);
    inside.hypotheses.insert_or_assign(opened(step.premises[0].conclusion(), variable), name);
    return fmt::format("destruct {} as [{} {}]. exact {}.", term(step.premises[0], scope),
                       identifier(variable.name), name, term(step.premises[1], inside));
  }
  if (is_calculus(step.rule)) {
    return calculus(theorem, scope);
  }
  throw KernelError("the rule " + step.rule + " has no counterpart in Coq yet");
}

}  // namespace stickslip::proofs::certificates
