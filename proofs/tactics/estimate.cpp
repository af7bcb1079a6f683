#include "proofs/tactics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "proofs/kernel/entrywise.hpp"

namespace stickslip::proofs::tactics {
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
