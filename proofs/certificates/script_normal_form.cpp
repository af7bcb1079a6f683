// Identities by normal form.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "core/transformed.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/phases.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// What a normal form takes as it stands: variables, functions and definitions applied, pi. What stands in
// the argument of a cos, sin or exp is part of a phase.
std::vector<Term> atoms_in(const std::vector<Term>& terms) {
  std::vector<Term> found;
  tactics::each_part(terms, [&](const Term& part) {
    const bool atom = part.kind() == Kind::variable || part.kind() == Kind::apply ||
                      part.kind() == Kind::defined || part.kind() == Kind::pi;
    if (atom && part.type().is_numeric()) {
      found.push_back(part);
    }
    return !atom && part.kind() != Kind::cosine && part.kind() != Kind::sine &&
           part.kind() != Kind::exponential;
  });
  return found;
}

// The entries of a matrix, row after row.
std::string entries(const Type& type, const std::string& name) {
  std::string names;
  for (int i = 1; i <= type.rows; ++i) {
    for (int j = 1; j <= type.columns; ++j) {
      names += fmt::format(" {}_{}{}", name, i, j);
    }
  }
  return names;
}

bool same_value(const Term& a, const Term& b) {
  return a == b || (a.type().is_numeric() && a.type() == b.type() && identity(a, b));
}

// Whether the normal form takes two atoms for one, though they are written differently.
bool same_atom(const Term& a, const Term& b) {
  if (a.kind() != b.kind() || (a.kind() == Kind::defined && a.definition() != b.definition())) {
    return false;
  }
  return std::equal(a.parts().begin(), a.parts().end(), b.parts().begin(), b.parts().end(), same_value);
}

// Writes equal atoms alike, in the terms and in Coq: in the goal and in these hypotheses.
std::string same_atoms(std::vector<Term>& terms, const std::vector<std::string>& hypotheses) {
  std::vector<Term> atoms;
  tactics::each_part(terms, [&](const Term& part) {
    const bool applied = part.kind() == Kind::apply || part.kind() == Kind::defined;
    if (applied) {
      atoms.push_back(part);
    }
    return !applied;
  });
  std::string text;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const auto first = std::find_if(atoms.begin(), atoms.begin() + static_cast<std::ptrdiff_t>(i),
                                    [&](const Term& atom) { return same_atom(atom, atoms[i]); });
    if (first != atoms.begin() + static_cast<std::ptrdiff_t>(i)) {
      text += fmt::format("  assert (Q'{0} : {1} = {2}) by same_atom. rewrite ?Q'{0}.\n", i, coq(atoms[i]),
                          coq(*first));
      for (const std::string& name : hypotheses) {
        text += fmt::format("  rewrite ?Q'{} in {}.\n", i, name);
      }
      for (Term& term : terms) {
        term = replaced(term, atoms[i], *first);
      }
    }
  }
  return text;
}

// The hypothesis of the step that says this of a divisor; null where none does.
const Formula * known_divisor(const Formula& divisor, const Step& step) {
  const Formula opened = unfold(divisor, step.unfolded);
  const auto known = std::find_if(step.divisors.begin(), step.divisors.end(), [&](const Formula& given) {
    return unfold(given, step.unfolded) == opened;
  });
  return known == step.divisors.end() ? nullptr : &*known;
}

// As few of the definitions as it takes for the term to vanish: what stays closed is one letter. A number
// that is not 0 may be known to be so only when it is open.
Definitions needed(const Term& whole, const Step& step) {
  Definitions result = step.unfolded;
  for (const Definition& definition : step.unfolded) {
    Definitions fewer = result;
    fewer.erase(definition);
    const std::optional<Theorem> vanishing = identity(whole, zero(whole.type()), fewer);
    if (vanishing &&
        std::all_of(vanishing->hypotheses().begin(), vanishing->hypotheses().end(),
                    [&](const Formula& divisor) { return known_divisor(divisor, step) != nullptr; })) {
      result = fewer;
    }
  }
  return result;
}

// What the term, unfolded already, divides by, as the kernel lists it.
Formulas divisors_of(const Term& term) {
  const std::optional<Theorem> vanishing = identity(term, zero(term.type()));
  return vanishing ? vanishing->hypotheses() : Formulas{};
}

// How often each entry of a matrix stands in its inverse, written out by cofactors, about.
double repeated_by(const Term& term) {
  double times = 1;
  if (term.kind() == Kind::inverse && !term.type().is_scalar()) {
    for (int k = 2; k <= term.type().rows; ++k) {
      times *= k * k;
    }
  }
  return times;
}

// How long a term is, written out, and how often each of its parts stands in it.
class Measure {
 public:
  explicit Measure(const Term& whole) {
    add(whole);
    counts[whole] = 1;
    for (auto term = parts.rbegin(); term != parts.rend(); ++term) {
      for (const Term& part : inside(*term)) {
        counts[part] += repeated_by(*term) * counts[*term];
      }
    }
  }
  [[nodiscard]] double all(const Term& part) { return counts[part] * sizes[part]; }

  std::map<Term, double> sizes, counts;
  std::vector<Term> parts;  // each before what it is part of

 private:
  static std::vector<Term> inside(const Term& term) {
    const bool closed =
        term.kind() == Kind::variable || term.kind() == Kind::apply || term.kind() == Kind::defined;
    return closed ? std::vector<Term>{} : term.parts();
  }
  double add(const Term& term) {
    if (const auto known = sizes.find(term); known != sizes.end()) {
      return known->second;
    }
    double size = 1;
    for (const Term& part : inside(term)) {
      size += repeated_by(term) * add(part);
    }
    parts.push_back(term);
    return sizes.emplace(term, size).first->second;
  }
};

struct Letter {
  Term stands_for;
  Variable name;
};

// Whether the first of the terms vanishes wherever none of the others does.
bool vanishes(const std::vector<Term>& terms) {
  const std::optional<Theorem> vanishing = identity(terms[0], zero(terms[0].type()));
  return vanishing && std::ranges::all_of(vanishing->hypotheses(), [&](const Formula& divisor) {
           return std::find(terms.begin() + 1, terms.end(), divisor.parts()[0].parts()[0]) != terms.end();
         });
}

// Of a long term: matrices that stand in it again and again, and may be any, replaced by letters in all
// terms. Those first that make up most of it.
std::vector<Letter> with_letters(std::vector<Term>& terms) {
  constexpr double is_long = 4000;
  constexpr int most_tries = 6;
  std::vector<Letter> letters;
  std::set<Term> tried;
  for (int tries = 0; tries < most_tries; ++tries) {
    Measure measure(terms[0]);
    if (measure.sizes[terms[0]] < is_long) {
      break;
    }
    const Term * best = nullptr;
    for (const Term& part : measure.parts) {
      const bool may_be = part.type().sort == Sort::real && !part.type().is_scalar() &&
                          measure.counts[part] >= 2 && measure.sizes[part] > 1 && !tried.contains(part);
      if (may_be && (best == nullptr || measure.all(part) > measure.all(*best))) {
        best = &part;
      }
    }
    if (best == nullptr) {
      break;
    }
    const Letter letter{*best, {fmt::format("letter {}", letters.size()), best->type()}};
    tried.insert(letter.stands_for);
    const auto others =
        transformed(terms, [&](const Term& term) { return replaced(term, letter.stands_for, letter.name); });
    if (vanishes(others)) {
      terms = others;
      letters.push_back(letter);
    }
  }
  return letters;
}

// Numbers in arguments, as few of them with a phase in common as it takes for the first term to vanish: else
// cos(8) and cos(3/2) would be polynomials in that of 1/2. Each at most with its double.
Numbers numbers_apart(const std::vector<Term>& terms) {
  const std::set<Rational> all = numbers_in_phases(terms);
  std::vector<std::pair<Rational, Rational>> doubles;
  for (const Rational& one : all) {
    if (all.contains(2 * one)) {
      doubles.emplace_back(one, 2 * one);
    }
  }
  const auto together = [&](const auto& pairs) {
    Numbers numbers;
    for (const Rational& one : all) {
      // The half comes before its double.
      const auto half = std::ranges::find_if(pairs, [&](const auto& pair) { return pair.second == one; });
      const auto of = half == pairs.end()
                          ? numbers.end()
                          : std::ranges::find_if(numbers, [&](const std::set<Rational>& some) {
                              return some.contains(half->first);
                            });
      if (of == numbers.end()) {
        numbers.push_back({one});
      } else {
        of->insert(one);
      }
    }
    return numbers;
  };
  if (all.size() < 2) {
    return together(doubles);
  }
  if (!vanishes(apart(terms, together(doubles)))) {
    return {all};
  }
  for (std::size_t k = doubles.size(); k-- > 0;) {
    auto fewer = doubles;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    if (vanishes(apart(terms, together(fewer)))) {
      doubles = fewer;
    }
  }
  return together(doubles);
}

}  // namespace

std::string Script::normal_form(const Term& left, const Term& right, const Step& step,
                                const Scope& scope) const {
  const Definitions opened = needed(difference(left, right), step);
  // The whole, then what it divides by.
  std::vector<Term> terms{unfold(difference(left, right), opened)};
  std::string text;
  std::vector<std::string> divisors;
  for (const Formula& divisor : divisors_of(terms[0])) {
    if (const Formula * known = known_divisor(divisor, step)) {
      divisors.push_back(fmt::format("n'{}", divisors.size()));
      text += fmt::format("  assert ({} : {}) by exact {}.\n", divisors.back(), coq(divisor),
                          hypothesis(*known, scope));
      terms.push_back(divisor.parts()[0].parts()[0]);
    }
  }
  text += opening("  ", opened, ".\n");
  text += same_atoms(terms, divisors);
  const auto listed = [&] { return fmt::format("{}", fmt::join(divisors, " ")); };
  const auto reverted = [&] { return divisors.empty() ? "" : fmt::format("  revert {}.\n", listed()); };
  if (const std::vector<Letter> letters = with_letters(terms); !letters.empty()) {
    text += reverted();
    for (const Letter& letter : letters) {
      text +=
          fmt::format("  generalize {}; intros {}.\n", coq(letter.stands_for), identifier(letter.name.name));
    }
    text += divisors.empty() ? "" : fmt::format("  intros {}.\n", listed());
    // What only letters divided by is needed no more.
    const Formulas left_over = divisors_of(terms[0]);
    for (std::size_t k = divisors.size(); k-- > 0;) {
      const auto is_it = [&](const Formula& one) { return one.parts()[0].parts()[0] == terms[k + 1]; };
      if (std::ranges::none_of(left_over, is_it)) {
        text += fmt::format("  clear {}.\n", divisors[k]);
        divisors.erase(divisors.begin() + static_cast<std::ptrdiff_t>(k));
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(k + 1));
      }
    }
  }
  const Phases phases = phases_of(terms, numbers_apart(terms));
  // Nothing else that is known is of use then.
  std::vector<std::string> known = divisors;
  const auto know = [&](const std::string& name) { known.push_back(name); };
  for (std::size_t i = 0; i < phases.circles.arguments.size(); ++i) {
    const auto& [argument, sum] = phases.circles.arguments[i];
    text += fmt::format("  assert (E'{0} : {1} = {2}) by angle.\n  expand_circle E'{0} C'{0} S'{0}.\n", i,
                        argument, sum);
    know(fmt::format("C'{}", i));
    know(fmt::format("S'{}", i));
  }
  for (std::size_t i = 0; i < phases.circles.phases.size(); ++i) {
    text += fmt::format("  pose proof (circle {}) as K'{}.\n", phases.circles.phases[i], i);
    know(fmt::format("K'{}", i));
  }
  if (phases.circles.of_zero) {
    text += "  pose proof cos_0 as C'; pose proof sin_0 as S'.\n";
    know("C'");
    know("S'");
  }
  for (std::size_t i = 0; i < phases.exponentials.arguments.size(); ++i) {
    const auto& [argument, sum] = phases.exponentials.arguments[i];
    text += fmt::format(
        "  assert (D'{0} : {1} = {2}) by angle.\n  expand_exponential D'{0} X'{0}. rewrite ?X'{0}.\n", i,
        argument, sum);
    for (const std::string& divisor : divisors) {
      text += fmt::format("  rewrite ?X'{} in {}.\n", i, divisor);
    }
  }
  for (std::size_t i = 0; i < phases.exponentials.phases.size(); ++i) {
    text += fmt::format("  pose proof (exp_differs {}) as N'{}.\n", phases.exponentials.phases[i], i);
    know(fmt::format("N'{}", i));
  }
  if (phases.exponentials.of_zero) {
    text += "  rewrite ?exp_0.\n";
  }
  std::vector<Term> atoms = atoms_in(terms);
  if (std::ranges::any_of(atoms, [](const Term& atom) { return atom.kind() == Kind::pi; })) {
    text += "  pose proof PI_neq0 as n'.\n";
    know("n'");
  }
  if (!known.empty()) {
    text += fmt::format("  revert {}.\n", fmt::join(known, " "));
  }
  // Variables last: others speak of them.
  std::erase_if(atoms, [](const Term& atom) { return atom.type().is_scalar(); });
  const auto is_variable = [](const Term& atom) { return atom.kind() == Kind::variable; };
  std::stable_partition(atoms.begin(), atoms.end(), std::not_fn(is_variable));
  text += "  forget.\n";
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    text += fmt::format("  {} {}; by_entries; intros{}.\n", is_variable(atoms[i]) ? "revert" : "generalize",
                        coq(atoms[i]), entries(atoms[i].type(), fmt::format("m'{}", i)));
  }
  text += "  reduce_matrices";
  if (!known.empty()) {
    text += fmt::format("; intros {}", fmt::join(known, " "));
  }
  return text + (divisors.empty() ? "" : "; split_factors") + "; by_fractions.\n";
}

}  // namespace stickslip::proofs::certificates
