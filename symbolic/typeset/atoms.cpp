#include "symbolic/typeset/polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "symbolic/algebra/symbols.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::symbolic::typeset {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

[[noreturn]] void cannot_print(const ex& part) {
  throw InternalError(
      fmt::format("a formula to be printed holds {}, which is not exact and scalar", algebra::plain(part)));
}

struct Argument {
  Sum terms;
  bool negative = false;  // the terms are those of the negated argument
};

// A term of an argument: rational coefficient, exponents of any sign.
using Laurent = Monomial;

// The part of a term that members of a group share: the frequency, and the rational coefficient if all agree.
Fraction to_group(std::vector<Laurent> members, std::size_t frequency, const Alphabet& alphabet) {
  const Rational first = members[0].coefficient;
  const bool agree = std::all_of(members.begin(), members.end(), [&](const Laurent& member) {
    return abs(member.coefficient) == abs(first);
  });
  const Rational common = agree ? first : Rational(sgn(first));
  Laurent factor{Degrees(alphabet.atoms.size()), common};
  factor.degrees[frequency] = 1;
  Power inner;
  for (Laurent& member : members) {
    member.coefficient /= common;
    --member.degrees[frequency];
    inner.sum.push_back(to_fraction(member, alphabet));
  }
  Fraction result = to_fraction(factor, alphabet);
  result.numerator.powers.push_back(std::move(inner));
  return result;
}

Sum collect_frequencies(std::vector<Laurent> terms, const Alphabet& alphabet) {
  Sum result;
  while (!terms.empty()) {
    const Laurent& first = terms[0];
    std::size_t frequency = 0;
    while (frequency < first.degrees.size() &&
           (first.degrees[frequency] < 1 || alphabet.atoms[frequency].kind != Atom::Kind::symbol ||
            !names_frequency(alphabet.atoms[frequency].name))) {
      ++frequency;
    }
    const auto shares = [&](const Laurent& term) {
      return frequency < term.degrees.size() && term.degrees[frequency] > 0;
    };
    const auto rest = std::stable_partition(terms.begin() + 1, terms.end(), shares);
    if (rest == terms.begin() + 1) {
      result.push_back(to_fraction(first, alphabet));
    } else {
      result.push_back(to_group({terms.begin(), rest}, frequency, alphabet));
    }
    terms.erase(terms.begin(), rest);
  }
  return result;
}

// The argument of cos, sin or tan.
Argument arrange_argument(const ex& argument) {
  const auto [rational, alphabet] = rationalize(argument);
  const ex parts = rational.normal().numer_denom();
  std::vector<Laurent> terms = to_polynomial(parts.op(0), alphabet);
  const Polynomial below = to_polynomial(parts.op(1), alphabet);
  if (below.size() > 1) {
    Fraction whole = arrange(argument);
    const bool negative = std::exchange(whole.negative, false);
    return {{std::move(whole)}, negative};
  }
  const bool negative = terms[0].coefficient / below[0].coefficient < 0;
  for (Laurent& term : terms) {
    term.coefficient /= below[0].coefficient * (negative ? -1 : 1);
    std::transform(term.degrees.begin(), term.degrees.end(), below[0].degrees.begin(), term.degrees.begin(),
                   std::minus<>());
  }
  return {collect_frequencies(std::move(terms), alphabet), negative};
}

struct Before {
  bool operator()(const Atom& a, const Atom& b) const { return std::is_lt(compare(a, b)); }
};

// Replaces what is not rational by variables.
struct Rationalizer : GiNaC::map_function {
  std::map<Atom, ex, Before> variables;

  ex variable(Atom atom) {
    const auto known = variables.find(atom);
    if (known != variables.end()) {
      return known->second;
    }
    return variables.emplace(std::move(atom), GiNaC::symbol()).first->second;
  }

  ex trigonometric(const GiNaC::function& function) {
    const ex normal = function.op(0).normal();
    const ex evaluated = normal.is_equal(function.op(0)) ? ex(function) : rebuilt(function, normal);
    if (!GiNaC::is_a<GiNaC::function>(evaluated)) {
      return (*this)(evaluated);  // a number, or the sign came out
    }
    const std::string name = GiNaC::ex_to<GiNaC::function>(evaluated).get_name();
    Argument arranged = arrange_argument(evaluated.op(0));
    const ex atom = variable({Atom::Kind::trigonometric, name, {std::move(arranged.terms)}});
    return arranged.negative && name != "cos" ? ex(-atom) : atom;
  }

  static ex rebuilt(const GiNaC::function& function, const ex& argument) {
    const std::string name = function.get_name();
    return name == "cos" ? cos(argument) : name == "sin" ? sin(argument) : tan(argument);
  }

  ex function(const GiNaC::function& e) {
    const std::string name = e.get_name();
    if (name == "cos" || name == "sin" || name == "tan") {
      return trigonometric(e);
    }
    Atom atom{Atom::Kind::function, name, {}};
    for (const ex& argument : e) {
      Fraction arranged = arrange(argument);
      arranged.negative = arranged.negative && name != "abs";
      atom.arguments.push_back({without_leading_minus(std::move(arranged))});
    }
    return variable(std::move(atom));
  }

  ex power(const ex& e) {
    if (!GiNaC::is_a<numeric>(e.op(1)) || !e.op(1).info(GiNaC::info_flags::rational)) {
      cannot_print(e);
    }
    const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
    if (exponent.is_integer()) {
      return pow((*this)(e.op(0)), exponent);
    }
    Atom atom{Atom::Kind::function, "root", {}};
    atom.arguments.push_back({without_leading_minus(arrange(e.op(0)))});
    atom.arguments.push_back({arrange(exponent.denom())});
    return pow(variable(std::move(atom)), exponent.numer());
  }

  ex operator()(const ex& e) override {
    if (GiNaC::is_a<numeric>(e) && e.info(GiNaC::info_flags::rational)) {
      return e;
    }
    if (GiNaC::is_a<GiNaC::symbol>(e) && e.return_type() == GiNaC::return_types::commutative) {
      return variable({Atom::Kind::symbol, GiNaC::ex_to<GiNaC::symbol>(e).get_name(), {}});
    }
    if (e.is_equal(GiNaC::Pi)) {
      return variable({Atom::Kind::pi, "pi", {}});
    }
    if (GiNaC::is_a<GiNaC::function>(e)) {
      return function(GiNaC::ex_to<GiNaC::function>(e));
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
      return power(e);
    }
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
      return e.map(*this);
    }
    cannot_print(e);
  }
};

}  // namespace

Rationalized rationalize(const ex& expression) {
  Rationalizer rationalizer;
  Rationalized result{rationalizer(expression), {}};
  for (auto& [atom, variable] : rationalizer.variables) {
    result.alphabet.atoms.push_back(atom);
    result.alphabet.variables.push_back(variable);
  }
  return result;
}

}  // namespace stickslip::symbolic::typeset
