// Truth tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/transformed.hpp"
#include "proofs/certificates/script.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// A formula over letters for its atoms, the same ones as before where they stood before.
std::string shape(const Formula& formula, std::map<Formula, std::string>& letters) {
  const auto joined = [&](const char * separator, const char * none) {
    const auto parts =
        transformed(formula.parts(), [&](const Formula& part) { return shape(part, letters); });
    return parts.empty() ? std::string(none) : fmt::format("({})", fmt::join(parts, separator));
  };
  switch (formula.kind()) {
    case Kind::conjunction:
      return joined(" /\\ ", "True");
    case Kind::disjunction:
      return joined(" \\/ ", "False");
    case Kind::implication:
      return joined(" -> ", "");
    case Kind::negation:
      return fmt::format("(~ {})", shape(formula.parts()[0], letters));
    default:
      return letters.emplace(formula, "A" + std::to_string(letters.size())).first->second;
  }
}

// The same as a sentence of prelude/Sentences.v.
std::string sentence(const Formula& formula, const std::map<Formula, std::string>& letters) {
  const std::vector<Term>& parts = formula.parts();
  const auto joined = [&](const char * word, const char * none) {
    std::string text = parts.empty() ? none : sentence(parts.back(), letters);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
      text = part == parts.rbegin() ? text : fmt::format("({} {} {})", word, sentence(*part, letters), text);
    }
    return text;
  };
  switch (formula.kind()) {
    case Kind::conjunction:
      return joined("Both", "Yes");
    case Kind::disjunction:
      return joined("Either", "No");
    case Kind::implication:
      return joined("Then", "");
    case Kind::negation:
      return fmt::format("(Then {} No)", sentence(parts[0], letters));
    default:
      return fmt::format("(Letter {})", letters.at(formula).substr(1));
  }
}

// Where the formula stands in a conjunction of conjunctions: after how many parts, and whether others follow;
// then within that.
std::optional<std::string> path_to(const Formula& formula, const Formula& whole) {
  if (whole == formula) {
    return "nil";
  }
  if (whole.kind() != Kind::conjunction) {
    return std::nullopt;
  }
  const std::vector<Term>& parts = whole.parts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (const auto inside = path_to(formula, parts[i])) {
      return fmt::format("({}%nat, {}) :: {}", i, i + 1 < parts.size(), *inside);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string Script::consequence(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (step.premises.size() == 1) {
    if (const auto path = path_to(theorem.conclusion(), step.premises[0].conclusion())) {
      const std::string whole = term(step.premises[0], scope);
      return *path == "nil" ? fmt::format("  exact {}.", whole)
                            : fmt::format("  exact_part ({}) {}.", *path, whole);
    }
  }
  std::map<Formula, std::string> letters;
  std::string statement, proofs;
  for (const Theorem& premise : step.premises) {
    statement += shape(premise.conclusion(), letters) + " -> ";
  }
  statement += shape(theorem.conclusion(), letters);
  std::map<std::string, Formula> atoms;
  for (const auto& [formula, letter] : letters) {
    atoms.emplace(letter, formula);
  }
  const auto names = transformed(atoms, [](const auto& atom) { return atom.first; });
  auto known = library_.tautologies.find(statement);
  if (known == library_.tautologies.end() || is_slow(known->second.file)) {
    const std::string name = fresh(file_ + "_truth"), all = fmt::format("{}", fmt::join(names, " "));
    std::string numbered, said;
    for (std::size_t i = 0; i < names.size(); ++i) {
      numbered += fmt::format("A{} :: ", i);
    }
    for (const Theorem& premise : step.premises) {
      said += fmt::format("(Then {} ", sentence(premise.conclusion(), letters));
    }
    said += sentence(theorem.conclusion(), letters) + std::string(step.premises.size(), ')');
    text_ += fmt::format("Lemma {} : {}{}.\nProof{}. exact (truth_table ({}nil) {} {} eq_refl). Qed.\n\n",
                         name, names.empty() ? "" : fmt::format("forall {} : Prop, ", all), statement,
                         names.empty() ? "" : ". intros " + all, numbered, names.size(), said);
    known = library_.tautologies.insert_or_assign(statement, Lemma{.file = file_, .name = name, .stated = {}})
                .first;
  }
  std::string call = imported(known->second).name;
  constexpr std::size_t is_long = 100;  // what is said there Coq finds in the premises and in the goal
  for (const auto& [letter, formula] : atoms) {
    const std::string atom = coq(formula);
    call += " " + (atom.size() < is_long ? atom : "_");
  }
  for (const Theorem& premise : step.premises) {
    call += " " + term(premise, scope);
  }
  return fmt::format("  exact ({}).", call);
}

}  // namespace stickslip::proofs::certificates
