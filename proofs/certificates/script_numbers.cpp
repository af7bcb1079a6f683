// Numbers in balls: signs, and Krawczyk's test.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "core/transformed.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// Whether Coq differentiates it.
bool has_slopes(const Term& term) {
  const bool known = term.kind() == Kind::variable || term.kind() == Kind::sum ||
                     term.kind() == Kind::product || term.kind() == Kind::power ||
                     term.kind() == Kind::cosine || term.kind() == Kind::sine;
  return term.variables().empty() || (known && std::ranges::all_of(term.parts(), has_slopes));
}

// Made of rational numbers alone.
bool is_rational(const Term& term) {
  const bool made = term.kind() == Kind::number || term.kind() == Kind::sum || term.kind() == Kind::product ||
                    term.kind() == Kind::power;
  return made && std::all_of(term.parts().begin(), term.parts().end(), is_rational);
}

std::string list(const std::vector<std::string>& items) {
  return items.empty() ? "nil" : fmt::format("({} :: nil)", fmt::join(items, " :: "));
}

// What is computed is computed in units of 2^-40.
constexpr int unit_exponent = 40;
// How far the derivatives may be from those at the middle: 2^-20.
constexpr long spread = 1L << (unit_exponent - 20);
// How large f may be in the middle, in parts of the radius: 2^-12.
constexpr long residual = 1L << (unit_exponent - 12);

std::string in_units(Real value) {
  return std::to_string(std::llround(std::ldexp(value, unit_exponent)));
}
std::string in_units(const Matrix& matrix) {
  const auto row_of = [](const auto& row) {
    return list(transformed(row, [](Real value) { return fmt::format("({})", in_units(value)); }));
  };
  return list(transformed(matrix.rowwise(), row_of)) + "%Z";
}

// "  cbv beta delta [H z0].", or nothing.
std::string opened_in(const Term& term) {
  return opening("  ", tactics::definitions_in({term}), ".\n");
}

// The shortest of the long numbers that a term, once it is opened, would hold more than once: those that
// stand in it so, or are given to a definition.
std::optional<Term> often_in(const Term& whole) {
  constexpr double is_long = 40;
  std::map<Term, double> sizes;
  std::map<Term, int> places;
  const auto visit = [&](const auto& self, const Term& term, int here) -> double {
    const bool binds = term.kind() == Kind::lambda || term.kind() == Kind::for_all ||
                       term.kind() == Kind::exists || term.kind() == Kind::finite;
    const auto [known, is_new] = sizes.emplace(term, 1);
    places[term] += here;
    if (is_new && !binds) {
      double size = 1;
      for (const Term& part : term.parts()) {
        size += self(self, part, term.kind() == Kind::defined ? 2 : 1);
      }
      sizes[term] = size;
    }
    return sizes[term];
  };
  visit(visit, whole, 1);
  std::optional<Term> found;
  for (const auto& [term, count] : places) {
    if (term.type().is_scalar() && count > 1 && sizes[term] >= is_long &&
        (!found || sizes[term] < sizes[*found])) {
      found = term;
    }
  }
  return found;
}

}  // namespace

// Of a formula without variables: letters for long numbers that it would hold again and again, with bounds.
std::string Script::lettered(Formula& said) const {
  std::string text;
  if (!said.variables().empty()) {
    return text;
  }
  orbits::Ranges ranges;
  while (const std::optional<Term> number = often_in(said)) {
    const Variable letter{fmt::format("letter {}", ranges.size())};
    const kernel::Interval range = orbits::bounded(*number, ranges, 40).range;
    const std::string shown = coq(*number), name = identifier(letter.name),
                      centre = coq(Term(Rational((range.first + range.second) / 2))),
                      reach = coq(Term(Rational((range.second - range.first) / 2)));
    text += fmt::format(
        "  assert (b' : {0} + -1 * {1} <= {2} <= {0} + {1}).\n  {{\n  apply by_distance.\n{3}"
        "  reduce_matrices; by_enclosure.\n  }}\n  revert b'; generalize {2}; intros {4} b'{5}.\n",
        centre, reach, shown, opened_in(*number), name, ranges.size());
    ranges.emplace(letter, range);
    said = replaced(said, *number, letter);
  }
  return text;
}

std::string Script::read_once(const Formula& relation) {
  constexpr std::size_t often = 3, is_long = 400;
  const auto counted = std::ranges::find_if(relation.parts(), [&](const Term& side) {
    const auto found = signs_.find(side);
    return found != signs_.end() && found->second.size() >= often;
  });
  if (counted == relation.parts().end()) {
    return "";
  }
  const Term& number = *counted;
  const auto [reading, is_new] = readings_.emplace(number, "");
  if (is_new) {
    const Definitions opened = tactics::definitions_in({number});
    const bool of_numbers = std::ranges::all_of(
        number.variables(), [](const Variable& variable) { return variable.type == real_number; });
    if (!of_numbers || coq(unfold(number, opened)).size() < is_long) {
      return "";
    }
    const std::vector<Variable> variables(number.variables().begin(), number.variables().end());
    const auto names = transformed(variables, [](const Variable& one) { return identifier(one.name); });
    const std::string name = fresh(file_ + "_number"), all_variables = binders(variables),
                      shown = coq(number),
                      open = opened.empty() ? "" : fmt::format(" delta [{}]", names_of(opened));
    text_ += fmt::format(
        "Definition {0} : Tree.expr := ltac:(let f := eval cbv beta{1} in (fun {2} => {3}) in number_read "
        "f).\n"
        "Lemma {0}_is : forall {2}, {3} = Tree.eval {0} {4}.\n"
        "Proof. intros {5}. exact_no_check (eq_refl {3}). Qed.\n\n",
        name, open, all_variables, shown, list(names), fmt::join(names, " "));
    reading->second = fmt::format("({}_is {})", name, fmt::join(names, " "));
  }
  return reading->second;
}

std::string Script::sign(const Theorem& theorem, const Scope& scope) {
  // Interval arithmetic takes Coq half a second to load, here and wherever this file is used.
  const bool denied = theorem.conclusion().kind() == Kind::negation;
  const Formula& relation = denied ? theorem.conclusion().parts()[0] : theorem.conclusion();
  if (std::ranges::all_of(relation.parts(), is_rational)) {
    return denied ? "  intros equal'; lra." : "  lra.";
  }
  if (theorem.conclusion() == less(0, pi())) {
    return "  exact PI_RGT_0.";
  }
  needs_.insert("Numbers");
  Formula said = theorem.conclusion();
  const std::string reading = read_once(relation);
  std::string text = reading.empty() ? lettered(said) + opened_in(said) : "";
  text += bounds_opened(theorem, scope);
  // The widest range is halved where it has to be: Coq's sine knows less of wide intervals than Arb's.
  std::string along;
  Rational widest = orbits::wide;
  const std::vector<Term>& data = theorem.derivation().data;
  for (std::size_t i = 2; i + 2 < data.size(); i += 3) {
    const Rational width = data[i + 2].value() - data[i + 1].value();
    if (width > widest) {
      widest = width;
      along = identifier(data[i].name());
    }
  }
  const std::string how = along.empty() ? "" : "_along", parts = along.empty() ? "" : " " + along;
  return text + (reading.empty() ? fmt::format("  reduce_matrices; by_enclosure{}{}.", how, parts)
                                 : fmt::format("  by_known_enclosure{} {}{}.", how, reading, parts));
}

// Jury's test is one inequality for each degree.
std::string Script::jury(const Theorem& theorem, const Scope& scope) {
  needs_.insert({"Stability", "Numbers"});
  const std::string open = opening("", tactics::definitions_in({theorem.conclusion()}), "; ");
  return bounds_opened(theorem, scope) +
         fmt::format(
             "  apply inside_by_schur; {}cbv beta iota delta [schur next Nat.sub]; reduce_matrices.\n"
             "  repeat split; by_enclosure.",
             open);
}

// The test of the prelude needs what the functions' slopes are nearly, and their inverse: whole numbers that
// pass.
std::string Script::one_zero(const Theorem& theorem) {
  needs_.insert({"Numbers", "Zeros"});
  const Step& step = theorem.derivation();
  const Variable X{step.data[0].name(), step.data[0].type()};
  const int n = X.type.rows;
  const std::string name = fresh(file_ + "_zero");
  std::vector<Variable> x;
  std::vector<Rational> middle;
  tactics::Point values;
  const auto end = [&](int i, int which) {
    return step.data[static_cast<std::size_t>(3 + 2 * i + which)].value();
  };
  const Rational radius = (end(0, 1) - end(0, 0)) / 2;
  Term f = step.data[1];
  for (int i = 0; i < n; ++i) {
    x.push_back({fmt::format("x{}", i)});
    middle.emplace_back((end(i, 0) + end(i, 1)) / 2);
    values.emplace(x.back(), middle.back());
    if ((end(i, 1) - end(i, 0)) / 2 != radius) {
      throw KernelError("a box whose sides differ has no counterpart in Coq yet");
    }
    f = replaced(f, entry(X, i), x.back());
  }
  if (f.kind() != Kind::matrix || n == 1) {
    throw KernelError("only systems written out have a counterpart in Coq yet");
  }
  const auto number = [](int i) { return static_cast<std::size_t>(i); };
  std::string letters, places;
  std::vector<std::string> functions, sides;
  Matrix slopes = Matrix::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    letters += fmt::format("x{} ", i);
    places += fmt::format(" (x {}%nat)", i);
    sides.push_back(fmt::format("({}, {})", coq(Term(end(i, 0))), coq(Term(end(i, 1)))));
    const Term& one = f.parts()[number(i)];
    functions.push_back(coq(one));
    if (!has_slopes(one)) {
      throw KernelError("such a derivative has no form in Coq yet: " + to_string(one));
    }
    for (int j = 0; j < n; ++j) {
      const Variable& by = x[number(j)];
      slopes(i, j) =
          tactics::estimated(Theorem::differentiate(lambda(by, one), by).conclusion().parts()[2], values);
    }
  }
  const std::string numbers = fmt::format("{0} {1}_g {1}_b {1}_r {2}%Z {1}_Y {1}_M {3}%Z {4}%Z", n, name,
                                          1L << unit_exponent, spread, residual);
  text_ += fmt::format(
      "(* A system of {1} equations, its box, and numbers for Krawczyk's test. *)\n"
      "Definition {0}_rows ({2}: R) : list R := {3}.\n"
      "Definition {0}_f (x : nat -> R) : list R := {0}_rows{4}.\n"
      "Definition {0}_g : list Tree.expr := ltac:(let t := eval cbv delta [{0}_rows] in {0}_rows in "
      "functions_read "
      "t).\n"
      "Definition {0}_b : list (Tree.expr * Tree.expr) := ltac:(numbers_read {5}).\n"
      "Definition {0}_r : Tree.expr := ltac:(numbers_read ({6})).\n"
      "Definition {0}_M : list (list Z) := {7}.\nDefinition {0}_Y : list (list Z) := {8}.\n"
      "Lemma {0}_read : forall x, {0}_f x = evaluated {1} {0}_g x.\n"
      "Proof. intros x. exact_no_check (eq_refl ({0}_f x)). Qed.\n"
      "Lemma {0}_passes : zero_test {9} = true.\n"
      "Proof. vm_cast_no_check (@eq_refl bool true). Qed.\n\n",
      name, n, letters, list(functions), places, list(sides), coq(radius), in_units(slopes),
      in_units(Matrix(slopes.inverse())), numbers);
  return fmt::format("  exact_no_check (zero_of_columns {0} {1}_f {2} {1}_read {1}_passes).", n, name,
                     numbers.substr(numbers.find(' ') + 1));
}

}  // namespace stickslip::proofs::certificates
