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

Theorem decided(const Formula& formula, bool holds, const KnownRoots& roots);

// That it holds, or does not, by what each part does, or one of them.
Theorem by_parts(const Formula& formula, bool holds, const KnownRoots& roots, const Formula& said) {
  const bool is_of_all = (formula.kind() == Kind::conjunction) == holds;
  std::vector<Theorem> parts;
  for (const Formula& part : formula.parts()) {
    if (is_of_all) {
      parts.push_back(decided(part, holds, roots));
    } else if (const auto found = attempt([&] { return decided(part, holds, roots); })) {
      return Theorem::consequence({*found}, said);
    }
  }
  return is_of_all ? Theorem::consequence(parts, said)
                   : throw KernelError("no part decides it: " + to_string(formula));
}

// The formula, or its negation.
Theorem decided(const Formula& formula, bool holds, const KnownRoots& roots) {
  const Formula said = holds ? formula : negation(formula);
  switch (formula.kind()) {
    case Kind::equal:
      return holds ? equation(formula, roots) : difference(formula, roots);
    case Kind::less:
    case Kind::at_most:
      return holds ? inequality(formula, roots) : not_below(formula, roots);
    case Kind::negation: {
      const Theorem inside = decided(formula.parts()[0], !holds, roots);
      return holds ? inside : Theorem::consequence({inside}, said);
    }
    case Kind::conjunction:
    case Kind::disjunction:
      return by_parts(formula, holds, roots, said);
    case Kind::exists: {
      const auto shown = [&](const Formula& one) { return decided(one, holds, roots); };
      return holds
                 ? there_are_slopes(
                       formula, [&](const Theorem& slope) { return without_hypotheses(slope, roots); }, shown)
                 : there_are_no_slopes(formula, shown);
    }
    default:
      throw KernelError("it is not decided at one point: " + to_string(formula));
  }
}

}  // namespace

Theorem certainly(const Formula& formula, const KnownRoots& roots) {
  return decided(formula, true, roots);
}

Theorem certainly_not(const Formula& formula, const KnownRoots& roots) {
  return decided(formula, false, roots);
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
