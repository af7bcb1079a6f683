#include "proofs/tactics/text.hpp"

#include <algorithm>

namespace stickslip::proofs::kernel {
namespace {

std::string joined(const Term& term, const std::string& separator) {
  std::string text;
  for (const Term& part : term.parts()) {
    text += (text.empty() ? "" : separator) + to_string(part);
  }
  return "(" + text + ")";
}

std::string of_parts(const std::string& name, const Term& term) {
  return name + joined(term, ", ");
}

// What a power or an entry is of.
std::string base(const Term& term) {
  const Kind kind = term.kind();
  const bool splits = kind == Kind::product || kind == Kind::power || kind == Kind::lambda ||
                      (kind == Kind::number && (term.value() < 0 || term.value().get_den() != 1));
  return splits ? "(" + to_string(term) + ")" : to_string(term);
}

// "there are a, b: …", with names that are free in nothing that is bound.
std::string binding(const std::string& one, const std::string& many, Term term) {
  if (!term.is_closed()) {
    return one + " " + term.name() + ": " + to_string(term.parts()[0]);
  }
  const Kind kind = term.kind();
  std::vector<std::string> names;
  while (term.kind() == kind) {
    std::string name = term.name().empty() ? "x" : term.name();
    while (std::any_of(term.variables().begin(), term.variables().end(),
                       [&](const Variable& free) { return free.name == name; })) {
      name += "'";
    }
    names.push_back(name);
    term = opened(term, Variable{name, term.binds()});
  }
  std::string text = (names.size() == 1 ? one : many) + " " + names.front();
  for (std::size_t i = 1; i < names.size(); ++i) {
    text += ", " + names[i];
  }
  return text + ": " + to_string(term);
}

}  // namespace

std::string to_string(const Term& term) {
  const std::vector<Term>& parts = term.parts();
  switch (term.kind()) {
    case Kind::variable:
      return term.name();
    case Kind::bound:
      return "#" + term.value().get_str();
    case Kind::number:
      return term.value().get_str();
    case Kind::pi:
      return "pi";
    case Kind::sum:
      return joined(term, " + ");
    case Kind::product:
      return to_string(parts[0]) + "*" + to_string(parts[1]);
    case Kind::power:
      return base(parts[0]) + "^" + term.value().get_str();
    case Kind::inverse:
      return of_parts("inverse", term);
    case Kind::cosine:
      return of_parts("cos", term);
    case Kind::sine:
      return of_parts("sin", term);
    case Kind::exponential:
      return of_parts("exp", term);
    case Kind::matrix:
      return of_parts("matrix" + std::to_string(term.row()) + "x" + std::to_string(term.column()), term);
    case Kind::entry:
      return base(parts[0]) + "[" + std::to_string(term.row()) + "," + std::to_string(term.column()) + "]";
    case Kind::defined:
      return of_parts(term.definition().name(), term);
    case Kind::apply:
      return to_string(parts[0]) + "(" + to_string(parts[1]) + ")";
    case Kind::equal:
      return joined(term, " = ");
    case Kind::less:
      return joined(term, " < ");
    case Kind::at_most:
      return joined(term, " <= ");
    case Kind::conjunction:
      return parts.empty() ? "true" : joined(term, " and ");
    case Kind::disjunction:
      return parts.empty() ? "false" : joined(term, " or ");
    case Kind::negation:
      return "not " + to_string(parts[0]);
    case Kind::implication:
      return joined(term, " => ");
    case Kind::lambda:
      return binding("lambda", "lambda", term);
    case Kind::for_all:
      return binding("for all", "for all", term);
    case Kind::exists:
      return binding("there is", "there are", term);
    case Kind::finite:
      return binding("finitely many", "finitely many", term);
    case Kind::derivative:
      return of_parts("derivative", term);
    case Kind::continuous:
      return of_parts("continuous", term);
    default:
      return of_parts("inside_unit_circle", term);
  }
}

std::string to_string(const Sequent& sequent) {
  std::string text;
  for (const Formula& hypothesis : sequent.hypotheses) {
    text += (text.empty() ? "" : ", ") + to_string(hypothesis);
  }
  return text + " |- " + to_string(sequent.conclusion);
}

}  // namespace stickslip::proofs::kernel
