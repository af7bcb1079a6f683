#include "proofs/tactics/closed.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "proofs/kernel/entrywise.hpp"
#include "proofs/tactics/algebraic_numbers.hpp"
#include "proofs/tactics/slopes.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

constexpr long bits = 256;

Theorem equation(const Formula& formula, const KnownRoots& roots) {
  const Term &a = formula.parts()[0], &b = formula.parts()[1];
  if (a == b) {
    return Theorem::reflexive(a);
  }
  const auto identity = attempt([&] { return Theorem::combination(formula, {}, definitions_in({formula})); });
  return without_hypotheses(identity ? *identity : equal_numbers(formula, roots), roots);
}

// a < b or a ≤ b, the latter also as a = b.
Theorem inequality(const Formula& formula, const KnownRoots& roots) {
  if (const auto by_balls = attempt([&] { return Theorem::sign(formula, roots.ranges, bits); })) {
    return *by_balls;
  }
  const Term &a = formula.parts()[0], &b = formula.parts()[1];
  if (formula.kind() == Kind::less) {
    throw KernelError("it does not hold, or is not decided in balls: " + to_string(formula));
  }
  return Theorem::consequence({equation(equal(a, b), roots), Theorem::trichotomy(a, b)}, formula);
}

// Two matrices differ in an entry.
Theorem difference(const Formula& formula, const KnownRoots& roots) {
  const Term &a = formula.parts()[0], &b = formula.parts()[1];
  const Type& type = a.type();
  if (type.is_scalar()) {
    return Theorem::sign(negation(formula), roots.ranges, bits);
  }
  const Variable A{"A", type}, B{"B", type};  // of any two: what a and b are made of need not be looked into
  for (int i = 0; i < type.rows; ++i) {
    for (int j = 0; j < type.columns; ++j) {
      const auto found = attempt([&] {
        const Theorem differs =
            Theorem::sign(negation(equal(entry(a, i, j), entry(b, i, j))), roots.ranges, bits);
        const Formula all = equal(A, B);
        const Theorem row =
            Theorem::combination(equal(entry(A, i, j), entry(B, i, j)),
                                 {{Theorem::assume(all), unit(1, type.rows, static_cast<std::size_t>(i)),
                                   unit(type.columns, 1, static_cast<std::size_t>(j))}});
        const Theorem here = Theorem::instantiate(Theorem::discharge(row, all), {{A, a}, {B, b}});
        return Theorem::consequence({here, differs}, negation(formula));
      });
      if (found) {
        return without_hypotheses(*found, roots);
      }
    }
  }
  throw KernelError("no entry is known to differ: " + to_string(formula));
}

// By trichotomy, from the opposite inequality.
Theorem not_below(const Formula& formula, const KnownRoots& roots) {
  const Term &a = formula.parts()[0], &b = formula.parts()[1];
  const Theorem opposite = certainly(formula.kind() == Kind::less ? at_most(b, a) : less(b, a), roots);
  return Theorem::consequence({opposite, Theorem::trichotomy(a, b)}, negation(formula));
}

// Of each part, or of one of them.
using Decide = Theorem (*)(const Formula&, const KnownRoots&);
Theorem of_all(const Formula& formula, Decide one, const KnownRoots& roots, const Formula& conclusion) {
  std::vector<Theorem> parts;
  for (const Formula& part : formula.parts()) {
    parts.push_back(one(part, roots));
  }
  return Theorem::consequence(parts, conclusion);
}
Theorem of_one(const Formula& formula, Decide one, const KnownRoots& roots, const Formula& conclusion) {
  for (const Formula& part : formula.parts()) {
    if (const auto found = attempt([&] { return one(part, roots); })) {
      return Theorem::consequence({*found}, conclusion);
    }
  }
  throw KernelError("no part decides it: " + to_string(formula));
}

}  // namespace

Theorem certainly(const Formula& formula, const KnownRoots& roots) {
  switch (formula.kind()) {
    case Kind::equal:
      return equation(formula, roots);
    case Kind::less:
    case Kind::at_most:
      return inequality(formula, roots);
    case Kind::negation:
      return certainly_not(formula.parts()[0], roots);
    case Kind::conjunction:
      return of_all(formula, certainly, roots, formula);
    case Kind::disjunction:
      return of_one(formula, certainly, roots, formula);
    case Kind::exists:
      return there_are_slopes(
          formula, [&](const Theorem& slope) { return without_hypotheses(slope, roots); },
          [&](const Formula& one) { return certainly(one, roots); });
    default:
      throw KernelError("it is not decided at one point: " + to_string(formula));
  }
}

Theorem certainly_not(const Formula& formula, const KnownRoots& roots) {
  switch (formula.kind()) {
    case Kind::equal:
      return difference(formula, roots);
    case Kind::less:
    case Kind::at_most:
      return not_below(formula, roots);
    case Kind::negation:
      return Theorem::consequence({certainly(formula.parts()[0], roots)}, negation(formula));
    case Kind::conjunction:
      return of_one(formula, certainly_not, roots, negation(formula));
    case Kind::disjunction:
      return of_all(formula, certainly_not, roots, negation(formula));
    case Kind::exists:
      return there_are_no_slopes(formula, [&](const Formula& one) { return certainly_not(one, roots); });
    default:
      throw KernelError("it is not decided at one point: " + to_string(formula));
  }
}

Theorem without_hypotheses(const Theorem& theorem, const KnownRoots& roots) {
  const auto is_known = [&](const Formula& one) {
    return std::ranges::any_of(roots.ranges,
                               [&](const auto& range) {
                                 const auto& [x, ends] = range;
                                 return one == at_most(ends.first, x) || one == at_most(x, ends.second);
                               }) ||
           std::ranges::any_of(roots.squares,
                               [&](const Theorem& square) { return square.hypotheses().contains(one); });
  };
  return settled_by(theorem, [&](const Formula& one) {
    return is_known(one) ? std::nullopt : std::optional(certainly(one, roots));
  });
}

namespace {

using namespace kernel;
using Real = long double;
using Reals = std::vector<Real>;

constexpr Real nearly = 1e-10L;

// Numbers between 1/2 and 3/2 that stand for something of which only name and arguments are known.
Reals made_up(const std::string& name, const Type& type, const std::vector<Reals>& arguments) {
  std::size_t seed = std::hash<std::string>{}(name);
  const auto mix = [&seed](std::size_t next) {
    seed = (seed ^ next) * 0x9e3779b97f4a7c15ULL + (seed >> 29U);
  };
  for (const Reals& argument : arguments) {
    for (const Real entry : argument) {
      mix(static_cast<std::size_t>(std::llround(entry * 1e8L)));
    }
  }
  Reals result(static_cast<std::size_t>(type.rows * type.columns));
  for (Real& entry : result) {
    mix(0x632be59bd9b4e019ULL);
    entry = 0.5L + static_cast<Real>(seed >> 11U) / static_cast<Real>(1ULL << 53U);
  }
  return result;
}

struct Floats {
  using Number = Real;
  Point values = {};
  const Definitions * unfolded = nullptr;  // all where there are none

  [[nodiscard]] static Real number(const Rational& value) { return static_cast<Real>(value.get_d()); }
  [[nodiscard]] static Real pi() { return std::numbers::pi_v<Real>; }
  [[nodiscard]] static Real reciprocal(Real value) { return 1 / value; }
  [[nodiscard]] static Real cosine(const Term& argument, auto& entries) {
    return std::cos(entries(argument)[0]);
  }
  [[nodiscard]] static Real sine(const Term& argument, auto& entries) {
    return std::sin(entries(argument)[0]);
  }
  [[nodiscard]] static Real exponential(const Term& argument, auto& entries) {
    return std::exp(entries(argument)[0]);
  }
  [[nodiscard]] Reals atom(const Term& term, auto& entries) const {
    const std::vector<Term>& parts = term.parts();
    if (term.kind() == Kind::variable) {
      const auto value = values.find({term.name(), term.type()});
      return value != values.end() ? Reals{number(value->second)} : made_up(term.name(), term.type(), {});
    }
    if (term.kind() == Kind::apply) {
      return made_up(parts[0].kind() == Kind::variable ? parts[0].name() : to_string(parts[0]), term.type(),
                     {entries(parts[1])});
    }
    if (unfolded == nullptr || unfolded->contains(term.definition())) {
      return entries(term.definition().unfolded(parts));
    }
    std::vector<Reals> arguments;
    for (const Term& argument : parts) {
      arguments.push_back(argument.type().is_numeric() ? entries(argument) : Reals{0});
    }
    return made_up(term.definition().name(), term.type(), arguments);
  }
};

Real largest(const Reals& entries) {
  Real result = 0;
  for (const Real one : entries) {
    if (!std::isfinite(one)) {
      return std::numeric_limits<Real>::infinity();
    }
    result = std::max(result, std::abs(one));
  }
  return result;
}

}  // namespace

long double estimated(const Term& number, const Point& values) {
  return Entrywise<Floats>({values})(number)[0];
}

bool seems_zero(const std::vector<Term>& parts, const Definitions& unfolded) {
  Entrywise<Floats> estimate({.unfolded = &unfolded});
  Reals total = estimate(parts.front());
  Real size = 1 + largest(total);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Reals& part = estimate(parts[i]);
    for (std::size_t k = 0; k < total.size(); ++k) {
      total[k] += part[k];
    }
    size = std::max(size, largest(part));
  }
  const Real rest = largest(total);
  return !std::isfinite(rest) || rest <= nearly * size;
}

}  // namespace stickslip::proofs::tactics
