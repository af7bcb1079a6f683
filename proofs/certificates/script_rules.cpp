// The rules that compute.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "proofs/certificates/phases.hpp"
#include "proofs/certificates/script.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// What a normal form takes as it stands and has entries: variables, functions and definitions applied.
void collect_matrices(const Term& term, std::vector<Term>& found, std::set<Term>& seen) {
  if (!seen.insert(term).second) {
    return;
  }
  const bool atom =
      term.kind() == Kind::variable || term.kind() == Kind::apply || term.kind() == Kind::defined;
  if (atom) {
    if (term.type().is_numeric() && !term.type().is_scalar()) {
      found.push_back(term);
    }
    return;
  }
  for (const Term& part : term.parts()) {
    collect_matrices(part, found, seen);
  }
}

// "[[a1 [a2 []]] [[a3 [a4 []]] []]]": a matrix taken apart.
std::string pattern(const Type& type, const std::string& name) {
  std::string rows = "[]";
  for (int i = type.rows; i > 0; --i) {
    std::string row = "[]";
    for (int j = type.columns; j > 0; --j) {
      row = fmt::format("[{}_{}{} {}]", name, i, j, row);
    }
    rows = fmt::format("[{} {}]", row, rows);
  }
  return rows;
}

// a + (-1) b, also of numbers: as rdiffer and mdiffer have it.
Term difference(const Term& a, const Term& b) {
  return sum({a, Term(-1) * b});
}

// left = right by normal form, with these definitions looked into; nothing where the kernel does not see it.
std::optional<Theorem> identity(const Term& left, const Term& right, const Definitions& unfolded = {}) {
  try {
    return Theorem::combination(equal(left, right), {}, unfolded);
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

bool same_value(const Term& a, const Term& b) {
  return a == b || (a.type().is_numeric() && b.type().is_numeric() && a.type().rows == b.type().rows &&
                    a.type().columns == b.type().columns && identity(a, b));
}

// Whether the normal form takes two atoms for one, though they are written differently.
bool same_atom(const Term& a, const Term& b) {
  if (a.kind() != b.kind() || (a.kind() == Kind::defined && a.definition() != b.definition())) {
    return false;
  }
  return std::equal(a.parts().begin(), a.parts().end(), b.parts().begin(), b.parts().end(), same_value);
}

void collect_applied(const Term& term, std::vector<Term>& found, std::set<Term>& seen) {
  if (!seen.insert(term).second || term.kind() == Kind::variable) {
    return;
  }
  if (term.kind() == Kind::apply || term.kind() == Kind::defined) {
    found.push_back(term);
    return;
  }
  for (const Term& part : term.parts()) {
    collect_applied(part, found, seen);
  }
}

// Writes equal atoms alike, in the terms and in Coq: in the goal and in these hypotheses.
std::string same_atoms(std::vector<Term>& terms, const std::vector<std::string>& hypotheses) {
  std::vector<Term> atoms;
  std::set<Term> seen;
  for (const Term& term : terms) {
    collect_applied(term, atoms, seen);
  }
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

// The zero of a combination; whole numbers are written as numbers.
std::string nothing(const Type& type) {
  return any_value(real_matrix(type.rows, type.columns));
}

std::string names_of(const Definitions& definitions) {
  std::vector<std::string> names;
  std::transform(definitions.begin(), definitions.end(), std::back_inserter(names),
                 [](const Definition& definition) { return definition_name(definition); });
  return fmt::format("{}", fmt::join(names, " "));
}

}  // namespace

std::string Script::normal_form(const Term& left, const Term& right, const Step& step,
                                const Scope& scope) const {
  const Term whole = difference(left, right);
  const Definitions opened = needed(whole, step);
  std::vector<Term> terms{unfold(whole, opened)};
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
  const std::string known = fmt::format("{}", fmt::join(divisors, " "));
  if (!opened.empty()) {
    text += fmt::format("  cbv beta delta [{}].\n", names_of(opened));
  }
  text += same_atoms(terms, divisors);
  const Phases phases = phases_of(terms);
  std::string expansions;
  for (std::size_t i = 0; i < phases.arguments.size(); ++i) {
    const auto& [argument, sum] = phases.arguments[i];
    text += fmt::format("  assert (E'{} : {} = {}) by angle.\n", i, argument, sum);
    expansions += fmt::format("  expand_circle E'{}.\n", i);
  }
  if (!divisors.empty()) {
    text += fmt::format("  revert {}.\n", known);
  }
  text += expansions;
  std::vector<std::string> circles;
  for (const std::string& phase : phases.phases) {
    const std::string n = std::to_string(circles.size());
    circles.push_back("K'" + n);
    text += fmt::format(
        "  generalize (circle {0}); generalize (cos {0}) (sin {0}); intros c'{1} s'{1} K'{1}.\n", phase, n);
  }
  std::vector<Term> matrices;
  std::set<Term> seen;
  for (const Term& term : terms) {
    collect_matrices(term, matrices, seen);
  }
  std::stable_sort(matrices.begin(), matrices.end(), [](const Term& a, const Term& b) {
    return (a.kind() == Kind::variable) < (b.kind() == Kind::variable);
  });
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const std::string shown = coq(matrices[i]), name = fmt::format("m'{}", i);
    text += matrices[i].kind() == Kind::variable
                ? fmt::format("  destruct {} as {}.\n", shown, pattern(matrices[i].type(), name))
                : fmt::format("  generalize {}; intros {}.\n", shown, pattern(matrices[i].type(), name));
  }
  if (!divisors.empty()) {
    text += fmt::format("  reduce_matrices; intros {}; split_factors.\n", known);
  }
  const std::string rewriting = circles.empty() ? "" : fmt::format(" [{}]", fmt::join(circles, " "));
  return text + fmt::format("  rewrite ?cos_0, ?sin_0; each_entry; first [ring{0} | field{0}; nonzero].\n",
                            rewriting);
}

// Σ left (a - b) right, and the proof that each of these products is 0, as terms z'1, z'2, ….
struct Script::Zeros {
  std::vector<Term> products;
  std::string proofs;
};

void Script::add_zero(Zeros& zeros, const Term& left, const Theorem& equation, const Term& right,
                      const Scope& scope) {
  const Term &a = equation.conclusion().parts()[0], &b = equation.conclusion().parts()[1];
  zeros.products.push_back(left * difference(a, b) * right);
  const Type& type = zeros.products.back().type();
  zeros.proofs +=
      fmt::format("  assert (z'{} : {} = {}) by (rewrite ({} {}); vanish).\n", zeros.products.size(),
                  coq(zeros.products.back()), nothing(type),
                  a.type().is_scalar() ? "rdiffer _ _" : "mdiffer _ _ _ _", term(equation, scope));
}

namespace {

// Which entry of a column of equations the step takes, if that is all it does: the multiplier is a row of
// zeros with a one.
std::optional<int> one_row(const Theorem& theorem) {
  const Step& step = theorem.derivation();
  if (step.premises.size() != 1 || step.data.size() != 3) {
    return std::nullopt;
  }
  const Term &column = step.premises[0].conclusion().parts()[0], &row = step.data[1];
  if (column.kind() != Kind::matrix || column.type().columns != 1 || row.kind() != Kind::matrix ||
      row.type().columns != column.type().rows) {
    return std::nullopt;
  }
  const auto unit = std::find(row.parts().begin(), row.parts().end(), Term(1));
  const auto i = unit - row.parts().begin();
  const bool alone = unit != row.parts().end() &&
                     std::count(row.parts().begin(), row.parts().end(), Term(0)) + 1 == row.type().columns;
  return alone && column.parts()[static_cast<std::size_t>(i)] == theorem.conclusion().parts()[0] &&
                 theorem.conclusion().parts()[1] == Term(0)
             ? std::optional(static_cast<int>(i))
             : std::nullopt;
}

}  // namespace

// inverse(A) M = N by M = A N, where that is said of two rows and nothing else is needed: without the
// determinant of A below every fraction.
std::string Script::solved(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const Term left = theorem.conclusion().parts()[0], right = theorem.conclusion().parts()[1];
  if (!step.premises.empty() || left.kind() != Kind::product || left.parts()[0].kind() != Kind::inverse ||
      left.parts()[0].type() != real_matrix(2, 2) || right.type() != real_matrix(2, 2) ||
      !identity(left.parts()[1], left.parts()[0].parts()[0] * right, step.unfolded)) {
    return "";
  }
  needs_.insert("Inverses");
  const Term A = left.parts()[0].parts()[0], M = left.parts()[1];
  std::vector<std::string> divisors;
  for (const Formula& divisor : step.divisors) {
    divisors.push_back(hypothesis(divisor, scope));
  }
  const std::string open =
      step.unfolded.empty() ? "" : fmt::format("cbv beta delta [{}] in *; ", names_of(step.unfolded));
  std::string tries;
  for (const std::string& divisor : divisors) {
    tries += fmt::format("{}nonzero_like {}", tries.empty() ? "" : " | ", divisor);
  }
  return fmt::format(
      "  apply (inverse_solves {} _ _).\n  {{\n  {}reduce_matrices; first [{}].\n  }}\n"
      "  apply (by_difference_m 2 2 _ _ {}); [|reflexivity].\n{}",
      coq(A), open, tries, nothing(right.type()),
      normal_form(difference(M, A * right), zero(right.type()), step, scope));
}

std::string Script::combination(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (const std::optional<int> row = one_row(theorem)) {
    return fmt::format("  exact (f_equal (fun A => ent {} 0 A) {}).", *row, term(step.premises[0], scope));
  }
  const Term left = theorem.conclusion().parts()[0], right = theorem.conclusion().parts()[1];
  if (const std::string text = solved(theorem, scope); !text.empty()) {
    return text;
  }
  Zeros zeros;
  for (std::size_t k = 0; k < step.premises.size(); ++k) {
    add_zero(zeros, step.data[2 * k + 1], step.premises[k], step.data[2 * k + 2], scope);
  }
  const bool scalar = left.type().is_scalar();
  std::string proof = zeros.products.empty() ? "eq_refl" : "z'1";
  for (std::size_t k = 2; k <= zeros.products.size(); ++k) {
    proof = fmt::format("({} {} z'{})", scalar ? "zero_plus _ _" : "zero_mplus _ _ _ _", proof, k);
  }
  const Term total = zeros.products.empty() ? zero(left.type()) : sum(zeros.products);
  return fmt::format("  apply ({} {}).\n  {{\n{}  }}\n  {{\n{}  exact {}.\n  }}",
                     scalar ? "by_difference _ _"
                            : fmt::format("by_difference_m {} {} _ _", left.type().rows, left.type().columns),
                     zeros.products.empty() ? nothing(left.type()) : coq(total),
                     normal_form(difference(left, right), total, step, scope), zeros.proofs, proof);
}

std::string Script::order(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  const Formula& inequality = step.data[0];
  std::vector<Term> parts;
  std::string positives;
  const auto is_equation = [](const Theorem& known) { return known.conclusion().kind() == Kind::equal; };
  const auto equations =
      static_cast<std::size_t>(std::count_if(step.premises.begin(), step.premises.end(), is_equation));
  // Products first: factor, square, how many inequalities; then multiples: left, right.
  std::size_t premise = 0, datum = 1;
  for (; datum < step.data.size() - 2 * equations; datum += 3) {
    Term product = step.data[datum] * power(step.data[datum + 1], 2);
    for (long n = step.data[datum + 2].value().get_num().get_si(); n > 0; --n, ++premise) {
      const Formula& known = step.premises[premise].conclusion();
      product = product * difference(known.parts()[1], known.parts()[0]);
      positives += fmt::format("  pose proof ({} _ _ {}) as p'{}.\n",
                               known.kind() == Kind::less ? "less_gap" : "at_most_gap",
                               term(step.premises[premise], scope), premise);
    }
    parts.push_back(product);
  }
  Zeros zeros;
  for (; premise < step.premises.size(); ++premise, datum += 2) {
    add_zero(zeros, step.data[datum], step.premises[premise], step.data[datum + 1], scope);
  }
  parts.insert(parts.end(), zeros.products.begin(), zeros.products.end());
  for (std::size_t k = 1; k <= zeros.products.size(); ++k) {
    positives += fmt::format("  pose proof (Req_le_sym _ _ z'{0}) as p''{0}.\n", k);
  }
  const Term total = parts.empty() ? Term(0) : sum(parts);
  return fmt::format(
      "  apply ({} _ _ {}).\n  {{\n{}  }}\n  {{\n{}{}  positive_sum.\n  }}",
      inequality.kind() == Kind::less ? "by_less" : "by_at_most", coq(total),
      normal_form(difference(inequality.parts()[1], inequality.parts()[0]), total, step, scope), zeros.proofs,
      positives);
}

std::string Script::sign(const Theorem& theorem) {
  needs_.insert("Numbers");
  std::vector<Definition> opened;
  collect_definitions(theorem.conclusion(), opened);
  std::string text;
  if (!opened.empty()) {
    text = fmt::format("  cbv beta delta [{}].\n", names_of(Definitions(opened.begin(), opened.end())));
  }
  // The widest range is halved where it has to be: Coq's sine knows less of wide intervals than Arb's.
  std::string along;
  Rational widest(1, 1000000);
  const std::vector<Term>& data = theorem.derivation().data;
  for (std::size_t i = 2; i + 2 < data.size(); i += 3) {
    const Rational width = data[i + 2].value() - data[i + 1].value();
    if (width > widest) {
      widest = width;
      along = fmt::format("_along {}", identifier(data[i].name()));
    }
  }
  return text + fmt::format("  reduce_matrices; by_enclosure{}.", along);
}

namespace {

// A formula over letters for its atoms, the same ones as before where they stood before.
std::string shape(const Formula& formula, std::map<Formula, std::string>& letters) {
  const auto joined = [&](const char * separator, const char * none) {
    std::vector<std::string> parts;
    for (const Formula& part : formula.parts()) {
      parts.push_back(shape(part, letters));
    }
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

}  // namespace

namespace {

// Where the formula stands in a conjunction of conjunctions, as a proof of it from a proof of the whole.
std::optional<std::string> projected(const Formula& whole, const Formula& formula, const std::string& proof) {
  if (whole == formula) {
    return proof;
  }
  if (whole.kind() != Kind::conjunction) {
    return std::nullopt;
  }
  std::string rest = proof;
  const std::vector<Term>& parts = whole.parts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    const auto found = projected(parts[i], formula, last ? rest : fmt::format("(proj1 {})", rest));
    if (found) {
      return found;
    }
    rest = fmt::format("(proj2 {})", rest);
  }
  return std::nullopt;
}

}  // namespace

std::string Script::consequence(const Theorem& theorem, const Scope& scope) {
  const Step& step = theorem.derivation();
  if (step.premises.size() == 1) {
    const auto found = projected(step.premises[0].conclusion(), theorem.conclusion(), "whole'");
    if (found) {
      return fmt::format("  pose proof {} as whole'. exact {}.", term(step.premises[0], scope), *found);
    }
  }
  std::map<Formula, std::string> letters;
  std::string statement, proofs;
  for (const Theorem& premise : step.premises) {
    statement += shape(premise.conclusion(), letters) + " -> ";
  }
  statement += shape(theorem.conclusion(), letters);
  auto known = library_.tautologies.find(statement);
  if (known == library_.tautologies.end()) {
    std::vector<std::string> names;
    std::transform(letters.begin(), letters.end(), std::back_inserter(names),
                   [](const auto& letter) { return letter.second; });
    std::sort(names.begin(), names.end());
    const std::string name = fresh(file_ + "_truth");
    text_ +=
        fmt::format("Lemma {} : {}{}.\nProof. truth_table. Qed.\n\n", name,
                    names.empty() ? "" : fmt::format("forall {} : Prop, ", fmt::join(names, " ")), statement);
    known = library_.tautologies.emplace(statement, Lemma{.file = file_, .name = name, .stated = {}}).first;
  }
  // Its letters by number.
  std::map<std::string, Formula> atoms;
  for (const auto& [formula, letter] : letters) {
    atoms.emplace(letter, formula);
  }
  std::vector<std::string> order;
  for (const auto& [letter, formula] : atoms) {
    order.push_back(letter);
  }
  std::string call = imported(known->second).name;
  for (const std::string& letter : order) {
    call += " " + coq(atoms.at(letter));
  }
  for (const Theorem& premise : step.premises) {
    call += " " + term(premise, scope);
  }
  return fmt::format("  exact ({}).", call);
}

}  // namespace stickslip::proofs::certificates
