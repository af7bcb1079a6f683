#include "proofs/orbits/enclosed_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

constexpr int rows = matrix_rows;
constexpr long bits = matrix_bits;

// Outwards to multiples of 2^-places, and one of them more.
Interval rounded(const Interval& range, int places) {
  const mpz_class unit = mpz_class(1) << static_cast<mp_bitcnt_t>(places);
  return {Rational(rounded_down(range.first, unit) - Rational(1, unit)),
          Rational(rounded_down(range.second, unit) + Rational(2, unit))};
}

// Bounds about what the term is nearly, as close as the ranges allow; else as they are found without that.
Interval enclosed(const Term& term, const Ranges& ranges, const Rational& width) {
  Point middle;
  for (const auto& [variable, range] : ranges) {
    middle.emplace(variable, (range.first.value() + range.second.value()) / 2);
  }
  const bool halves = std::ranges::any_of(
      ranges, [](const auto& one) { return one.second.second.value() - one.second.first.value() > wide; });
  const auto near = static_cast<double>(estimated(term, middle));
  const auto lies_in = [&](const Interval& bounds) {
    return holds(less(bounds.first, term), ranges, bits) && holds(less(term, bounds.second), ranges, bits);
  };
  if (std::isfinite(near)) {
    const auto about = [&](const Rational& radius) {
      return Interval{Rational(near) - radius, Rational(near) + radius};
    };
    for (Rational radius = width / 4; radius < 1; radius *= 4) {
      if (!lies_in(about(radius))) {
        continue;
      }
      if (halves && radius > width) {
        for (Rational step = radius / 2; step > radius / 16; step /= 2) {
          radius -= lies_in(about(radius - step)) ? step : Rational(0);
        }
        radius *= Rational(5, 4);  // Coq's interval arithmetic is another, and finds it, too
      }
      return about(radius);
    }
  }
  return enclosure(term, ranges, width);
}

}  // namespace

Known bounded(const Term& term, const Ranges& ranges, int places) {
  const Ranges here = ranges_in(term, ranges);
  const Interval range = rounded(enclosed(term, here, Rational(1, 1L << places)), places);
  return {term, range, Theorem::sign(at_most(range.first, term), here, bits),
          Theorem::sign(at_most(term, range.second), here, bits)};
}

std::map<Term, Known> bounds_said(const std::vector<Theorem>& theorems) {
  std::map<Term, Theorem> lower;
  std::map<Term, Known> result;
  for (const Theorem& theorem : theorems) {
    const Formula& said = theorem.conclusion();
    if (said.kind() != Kind::less && said.kind() != Kind::equal) {
      continue;
    }
    const Term &a = said.parts()[0], &b = said.parts()[1];
    const bool has_number = b.kind() == Kind::number;
    if (said.kind() == Kind::less && a.kind() == Kind::number && !has_number) {
      lower.emplace(b, Theorem::order(at_most(a, b), {Positive{{theorem}}}));
    } else if (said.kind() == Kind::less && has_number && lower.contains(a)) {
      result.emplace(a, Known{a,
                              {lower.at(a).conclusion().parts()[0].value(), b.value()},
                              lower.at(a),
                              Theorem::order(at_most(a, b), {Positive{{theorem}}})});
    } else if (said.kind() == Kind::equal && has_number && a.kind() == Kind::entry) {
      result.emplace(a, Known{a,
                              {b.value(), b.value()},
                              Theorem::order(at_most(b, a), {}, {{theorem}}),
                              Theorem::order(at_most(a, b), {}, {{theorem, -1}})});
    }
  }
  return result;
}

Theorem settled(const Theorem& theorem, const Letters& letters) {
  Substitution values;
  std::map<Formula, Theorem> known;
  for (const auto& [letter, one] : letters) {
    values.emplace(letter, one.value);
    known.emplace(one.lower.conclusion(), one.lower);
    known.emplace(one.upper.conclusion(), one.upper);
  }
  return settled_by(Theorem::instantiate(theorem, values), [&](const Formula& one) {
    const auto lemma = known.find(one);
    return lemma != known.end() ? std::optional(lemma->second) : std::nullopt;
  });
}

Ranges ranges_of(const Letters& letters) {
  Ranges ranges;
  for (const auto& [letter, one] : letters) {
    ranges.emplace(letter, one.range);
  }
  return ranges;
}

namespace {

// Bounds of all entries of a matrix of four rows, row by row.
using Bounds = std::vector<Interval>;

std::string place(int i) {
  return fmt::format("{}{}", i / rows + 1, i % rows + 1);
}
Term entry_of(const Term& M, int i) {
  return entry(M, i / rows, i % rows);
}

// lies_between(M, l11, u11, l12, …): each entry of M lies between its bounds.
struct Between {
  Variable M{"M", real_matrix(rows, rows)};
  std::vector<Term> entries, ends;
  std::vector<Variable> parameters{M};
  std::vector<Formula> parts;
  Between() {
    for (int i = 0; i < rows * rows; ++i) {
      const Variable l{"l" + place(i)}, u{"u" + place(i)};
      entries.emplace_back(Variable{"e" + place(i)});
      ends.insert(ends.end(), {l, u});
      parameters.insert(parameters.end(), {l, u});
      parts.insert(parts.end(), {at_most(l, entry_of(M, i)), at_most(entry_of(M, i), u)});
    }
  }
};
const Between& between_letters() {
  static const Between letters;
  return letters;
}
const Definition& lies_between() {
  static const Definition definition("lies_between", between_letters().parameters,
                                     all(between_letters().parts));
  return definition;
}
Formula enclosed(const Term& M, const Bounds& bounds) {
  std::vector<Term> arguments{M};
  for (const auto& [lower, upper] : bounds) {
    arguments.insert(arguments.end(), {lower, upper});
  }
  return lies_between()(arguments);
}

// l11 <= e11, e11 <= u11, … ⊢ lies_between of the matrix with the entries e11, ….
const Theorem& entry_by_entry() {
  static const Theorem theorem = [] {
    const Between& b = between_letters();
    const Term M = matrix(rows, rows, b.entries);
    std::vector<Theorem> parts;
    std::vector<Term> arguments{M};
    arguments.insert(arguments.end(), b.ends.begin(), b.ends.end());
    for (std::size_t i = 0; i < b.entries.size(); ++i) {
      const Theorem same = Theorem::combination(equal(b.entries[i], entry_of(M, static_cast<int>(i))));
      const Variable at{"e"};
      for (const auto& side : {at_most(b.ends[2 * i], at), at_most(at, b.ends[2 * i + 1])}) {
        parts.push_back(
            Theorem::replace(same, at, side, Theorem::assume(substitute(side, {{at, b.entries[i]}}))));
      }
    }
    return Theorem::convert(both(parts), lies_between()(arguments), {lies_between()});
  }();
  return theorem;
}

}  // namespace

Letters entries_of(const Variable& M, const Bounds& bounds) {
  const Formula said = enclosed(M, bounds);
  const Theorem known =
      Theorem::convert(Theorem::assume(said), unfold(said, {lies_between()}), {lies_between()});
  Letters letters;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    letters.emplace(
        Variable{M.name + "_" + place(static_cast<int>(i))},
        Known{entry_of(M, static_cast<int>(i)), bounds[i], part(known, 2 * i), part(known, 2 * i + 1)});
  }
  return letters;
}
Matrix matrix_of(const std::vector<Term>& entries, const Ranges& ranges, const Letters& letters,
                 const Theorem& is_matrix) {
  const Between& b = between_letters();
  Substitution values;
  std::vector<Theorem> sides;
  Bounds bounds;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Known one = bounded(entries[i], ranges);
    bounds.push_back(one.range);
    for (const Theorem& side : {one.lower, one.upper}) {
      sides.push_back(settled(side, letters));
    }
    values.emplace(Variable{b.entries[i].name()}, sides.back().conclusion().parts()[0]);
    values.emplace(Variable{b.ends[2 * i].name()}, one.range.first);
    values.emplace(Variable{b.ends[2 * i + 1].name()}, one.range.second);
  }
  Theorem known = Theorem::instantiate(entry_by_entry(), values);
  for (const Theorem& side : sides) {
    known = Theorem::cut(side, known);
  }
  return {is_matrix.conclusion().parts()[1], bounds, by_rewriting(known, is_matrix)};
}

namespace {

// The letter of an entry.
Term letter(const Variable& M, int i, int j) {
  return Variable{M.name + "_" + place(rows * i + j)};
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& p) {
  const Variable A{"A", real_matrix(rows, rows)}, P{"P", real_matrix(rows, rows)};
  Letters letters = entries_of(A, a.bounds);
  letters.merge(entries_of(P, p.bounds));
  std::vector<Term> sums, entries;
  for (int i = 0; i < rows * rows; ++i) {
    std::vector<Term> lettered, parts;
    for (int k = 0; k < rows; ++k) {
      lettered.push_back(letter(A, i / rows, k) * letter(P, k, i % rows));
      parts.push_back(entry(A, i / rows, k) * entry(P, k, i % rows));
    }
    sums.push_back(sum(lettered));
    entries.push_back(sum(parts));
  }
  const Matrix lemma = matrix_of(sums, ranges_of(letters), letters,
                                 Theorem::combination(equal(matrix(rows, rows, entries), Term(A) * Term(P))));
  const Theorem known = Theorem::instantiate(lemma.known, {{A, a.value}, {P, p.value}});
  return {a.value * p.value, lemma.bounds, Theorem::cut(p.known, Theorem::cut(a.known, known))};
}

}  // namespace stickslip::proofs::orbits
