#include "proofs/certificates/script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/tactics/tactics.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// Steps that are written where they are used, however often.
bool is_a_word(const std::string& rule) {
  return rule == "assume" || rule == "reflexive" || rule == "trichotomy" || rule == "sine_is_positive" ||
         rule == "square_root";
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

// x <= 3/2, 1 < f(x), ….
bool is_bound_by_number(const Formula& formula) {
  return (formula.kind() == Kind::at_most || formula.kind() == Kind::less) &&
         std::ranges::any_of(formula.parts(), [](const Term& side) { return side.kind() == Kind::number; });
}

// What a sign says, or denies.
const Formula& relation_of(const Formula& sign) {
  return sign.kind() == Kind::negation ? sign.parts()[0] : sign;
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
    for (const Formula& hypothesis : theorem.hypotheses()) {
      ++assumed_[hypothesis];
    }
    if (const auto bounded = bounded_by(theorem)) {
      bounds_[bounded->first].at(bounded->second) = theorem;
    }
    if (theorem.derivation().rule == "sign") {
      for (const Term& side : relation_of(theorem.conclusion()).parts()) {
        if (!side.variables().empty()) {
          signs_[side].insert(theorem.hypotheses());
        }
      }
    }
    for (const Theorem& premise : theorem.derivation().premises) {
      count(premise);
    }
  }
}

std::optional<std::pair<Script::Bounded, std::size_t>> Script::bounded_by(const Theorem& sign) {
  const Formula& said = sign.conclusion();
  const bool is_bound = said.kind() == Kind::at_most || said.kind() == Kind::less;
  if (sign.derivation().rule != "sign" || !is_bound) {
    return std::nullopt;
  }
  const std::vector<Term>& sides = said.parts();
  const std::size_t above = sides[1].kind() == Kind::number ? 1 : 0;
  const Term& number = sides[1 - above];
  if (sides[above].kind() != Kind::number || number.variables().empty()) {
    return std::nullopt;
  }
  return std::pair{Bounded{sign.hypotheses(), said.kind() == Kind::less, number}, above};
}

void Script::add(const std::string& name, const Theorem& theorem, const std::string& comment) {
  library_.alive.push_back(theorem);
  count(theorem);
  Lemma claim{.file = file_, .name = name, .stated = {}};
  state(comment.empty() ? "Theorem" : "(* " + comment + " *)\nTheorem", claim, theorem);
}

std::pair<Script::Scope, std::string> Script::opened_scope(const Stated& stated) {
  Scope scope{.hypotheses = {}, .variables = {}};
  std::string names;
  for (const Variable& variable : stated.variables) {
    scope.variables.insert(variable);
    names += " " + identifier(variable.name);
  }
  for (const Formula& formula : stated.hypotheses) {
    const std::string label = "hyp" + std::to_string(scope.hypotheses.size() + 1);
    scope.hypotheses.emplace(formula, label);
    names += " " + label;
  }
  return {scope, names.empty() ? "" : fmt::format("intros{}.\n", names)};
}

// Puts the lemmas that it needs before it.
void Script::state(const std::string& word, const Lemma& name, const Theorem& theorem) {
  Lemma lemma = name;
  lemma.stated = word == "Lemma" ? stated(theorem, [&](const Formula& formula) { return said(formula); })
                                 : stated(theorem);
  collect_definitions(theorem, definitions_);
  const auto [scope, names] = opened_scope(lemma.stated);
  const bool again = word != "Lemma" && known(theorem) != nullptr;
  const std::string proof =
      again || is_a_term(theorem.derivation().rule)
          ? fmt::format("exact {}.", again ? term(theorem, scope) : inlined(theorem, scope))
          : tactics(theorem, scope);
  if (word == "Lemma" && known(theorem) != nullptr) {
    return;  // what it follows from says the same
  }
  text_ +=
      fmt::format("{} {} :\n{}.\nProof.\n{}{}\nQed.\n\n", word, lemma.name, lemma.stated.text, names, proof);
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

bool Script::state_between(const Theorem& theorem) {
  const auto bounded = bounded_by(theorem);
  const auto found = bounded ? bounds_.find(bounded->first) : bounds_.end();
  if (found == bounds_.end() || !found->second[0] || !found->second[1] ||
      found->second.at(bounded->second)->conclusion() !=
          theorem.conclusion()) {  // of several bounds, one pair
    return false;
  }
  const std::array<Theorem, 2> sides{*found->second[0], *found->second[1]};
  const Theorem both = tactics::both({sides[0], sides[1]});
  Lemma lemma{.file = file_,
              .name = fresh(file_ + "_between"),
              .stated = stated(both, [&](const Formula& formula) { return said(formula); })};
  collect_definitions(both, definitions_);
  const auto [scope, names] = opened_scope(lemma.stated);
  text_ += fmt::format("Lemma {} :\n{}.\nProof.\n{}{}\nQed.\n\n", lemma.name, lemma.stated.text, names,
                       sign(sides[0], scope));
  for (const std::size_t side : {0U, 1U}) {
    lemma.half = side == 0 ? "proj1" : "proj2";
    library_.lemmas.insert_or_assign(std::pair{sides.at(side).hypotheses(), sides.at(side).conclusion()},
                                     lemma);
  }
  return true;
}

const Lemma& Script::lemma(const Theorem& theorem) {
  if (known(theorem) == nullptr && !state_between(theorem)) {
    state("Lemma", {.file = file_, .name = fresh(file_ + "_step"), .stated = {}}, theorem);
  }
  return imported(*library_.find(theorem));
}

std::string Script::applied(const Lemma& lemma, const Scope& scope, const Substitution& values) const {
  if (lemma.stated.variables.empty() && lemma.stated.hypotheses.empty() && lemma.half.empty()) {
    return lemma.name;
  }
  std::string call = "(" + (lemma.half.empty() ? "" : lemma.half + " (") + lemma.name;
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
  return call + (lemma.half.empty() ? ")" : "))");
}

std::string Script::hypothesis(const Formula& formula, const Scope& scope) const {
  const auto found = scope.hypotheses.find(formula);
  if (found == scope.hypotheses.end()) {
    throw KernelError("no hypothesis says " + to_string(formula));
  }
  return found->second;
}

// Coq takes as long to read a number of twenty digits as to read a hundred letters.
bool Script::is_named_bound(const Formula& formula) const {
  constexpr int often = 3;
  const auto found = assumed_.find(formula);
  return found != assumed_.end() && found->second >= often && is_bound_by_number(formula) &&
         coq_premise(formula).size() >= 30;
}

// "  cbv beta delta [file_said3] in hyp1.", where bounds have names.
std::string Script::bounds_opened(const Theorem& theorem, const Scope& scope) const {
  std::vector<std::string> names, labels;
  for (const Formula& one : theorem.hypotheses()) {
    const auto name = names_.find(one), label = scope.hypotheses.find(one);
    if (name != names_.end() && label != scope.hypotheses.end() && is_named_bound(one)) {
      names.push_back(name->second);
      labels.push_back(label->second);
    }
  }
  return names.empty()
             ? ""
             : fmt::format("  cbv beta delta [{}] in {}.\n", fmt::join(names, " "), fmt::join(labels, ", "));
}

std::string Script::said(const Formula& formula) {
  const std::string text = coq_premise(formula);
  const bool is_long = formula.kind() == Kind::conjunction && text.size() >= 300;
  if (!is_long && !is_named_bound(formula)) {
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
  if (step.rule == "trichotomy") {
    return fmt::format("(trichotomy {} {})", coq(within_scope(step.data[0], scope.variables)),
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
    return sign(theorem, scope);
  }
  if (step.rule == "jury") {
    return jury(theorem, scope);
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
  return calculus(theorem, scope);
}

}  // namespace stickslip::proofs::certificates
