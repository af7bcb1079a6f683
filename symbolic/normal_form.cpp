#include "symbolic/normal_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "symbolic/evaluate.hpp"

namespace stickslip::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

bool is_function(const ex& e, const char* name) {
  return is_a<GiNaC::function>(e) && ex_to<GiNaC::function>(e).get_name() == name;
}

// A rational combination of monomials plus a rational multiple of π.
struct Phase {
  std::vector<std::pair<ex, numeric>> terms;  // monomial, coefficient
  numeric half_turns = 0;                     // the multiple of π
};

bool is_monomial_factor(const ex& e) {
  if (is_a<GiNaC::symbol>(e) || e.is_equal(GiNaC::Pi)) {
    return true;
  }
  return is_a<GiNaC::power>(e) && is_monomial_factor(e.op(0)) && e.op(1).info(GiNaC::info_flags::integer);
}

// Splits a term into its rational coefficient and its monomial.
std::pair<numeric, ex> split(const ex& term) {
  numeric coefficient = 1;
  ex monomial = 1;
  const auto take = [&](const ex& factor) {
    if (factor.info(GiNaC::info_flags::rational)) {
      coefficient *= ex_to<numeric>(factor);
    } else if (is_monomial_factor(factor)) {
      monomial *= factor;
    } else {
      throw OutsideField("the phase term " + plain(term) + " is not a rational multiple of a monomial");
    }
  };
  if (is_a<GiNaC::mul>(term)) {
    for (const ex& factor : term) {
      take(factor);
    }
  } else {
    take(term);
  }
  return {coefficient, monomial};
}

Phase phase_of(const ex& argument) {
  const ex expanded = argument.normal().expand();
  Phase phase;
  const auto take = [&](const ex& term) {
    auto [coefficient, monomial] = split(term);
    if (monomial.is_equal(GiNaC::Pi)) {
      phase.half_turns += coefficient;
    } else if (!monomial.is_equal(1)) {
      phase.terms.emplace_back(monomial, coefficient);
    } else if (!coefficient.is_zero()) {
      throw OutsideField("the phase " + plain(argument) + " contains a number that is not a multiple of pi");
    }
  };
  if (is_a<GiNaC::add>(expanded)) {
    for (const ex& term : expanded) {
      take(term);
    }
  } else {
    take(expanded);
  }
  if (!(phase.half_turns * 2).is_integer()) {
    throw OutsideField("the phase " + plain(argument) + " contains a multiple of pi other than k*pi/2");
  }
  return phase;
}

void visit_trigonometric(const ex& e, const auto& visitor) {
  if (is_function(e, "cos") || is_function(e, "sin") || is_function(e, "tan")) {
    visitor(e.op(0));
    return;
  }
  if (is_a<GiNaC::function>(e)) {
    throw OutsideField("the function " + ex_to<GiNaC::function>(e).get_name() + " is not trigonometric");
  }
  if (is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer)) {
    throw OutsideField("the power " + plain(e) + " is not rational");
  }
  for (const ex& operand : e) {
    visit_trigonometric(operand, visitor);
  }
}

// cos and sin of an angle.
struct Pair {
  ex c;
  ex s;
};

Pair sum_of_angles(const Pair& a, const Pair& b) {
  return {(a.c * b.c - a.s * b.s).expand(), (a.s * b.c + a.c * b.s).expand()};
}

// Polynomials in s mod s² = 1 - c².
ex reduce_square(const ex& polynomial, const ex& c, const ex& s) {
  const ex expanded = polynomial.expand();
  const int degree = expanded.degree(s);
  if (degree < 2) {
    return expanded;
  }
  ex result = 0;
  for (int k = 0; k <= degree; ++k) {
    result += expanded.coeff(s, k) * GiNaC::pow(1 - c * c, k / 2) * (k % 2 == 0 ? ex(1) : s);
  }
  return result.expand();
}

// π as a generator: GiNaC divides and factors polynomials in symbols, not beside constants.
const ex& pi_generator() {
  static const ex generator = GiNaC::symbol("pi");
  return generator;
}

// The degree of an expression in a symbol as it stands, without expanding: at least the true one. Nothing if
// the symbol stands in a function or below a fraction bar.
std::optional<int> written_degree(const ex& e, const ex& symbol) {
  if (e.is_equal(symbol)) {
    return 1;
  }
  if (!e.has(symbol)) {
    return 0;
  }
  if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::posint)) {
    const auto base = written_degree(e.op(0), symbol);
    return base ? std::optional(*base * ex_to<numeric>(e.op(1)).to_int()) : std::nullopt;
  }
  const bool product = is_a<GiNaC::mul>(e);
  if (!product && !is_a<GiNaC::add>(e)) {
    return std::nullopt;
  }
  int degree = 0;
  for (const ex& operand : e) {
    const auto part = written_degree(operand, symbol);
    if (!part) {
      return std::nullopt;
    }
    degree = product ? degree + *part : std::max(degree, *part);
  }
  return degree;
}

// e = constant + slope * symbol, for a written degree of at most 1.
struct Linear {
  ex constant;
  ex slope;
};

Linear linear_parts(const ex& e, const ex& symbol) {
  if (e.is_equal(symbol)) {
    return {0, 1};
  }
  if (!e.has(symbol)) {
    return {e, 0};
  }
  Linear result{is_a<GiNaC::mul>(e) ? 1 : 0, 0};
  if (is_a<GiNaC::add>(e)) {
    for (const ex& operand : e) {
      const Linear part = linear_parts(operand, symbol);
      result.constant += part.constant;
      result.slope += part.slope;
    }
    return result;
  }
  for (const ex& operand : e) {
    const Linear part = linear_parts(operand, symbol);
    // One factor alone has a slope.
    result.slope = part.slope * result.constant + part.constant * result.slope;
    result.constant *= part.constant;
  }
  return result;
}

// A symbol in which the expression is linear as it stands.
std::optional<ex> linear_symbol(const ex& e) {
  for (const ex& symbol : symbols_of(e)) {
    if (written_degree(e, symbol) == 1) {
      return symbol;
    }
  }
  return std::nullopt;
}

class ToGenerators : public GiNaC::map_function {
 public:
  explicit ToGenerators(const std::vector<Circle>& circles) : circles_(circles) {}

  ex operator()(const ex& e) override {
    if (is_function(e, "cos")) {
      return pair(e.op(0)).c;
    }
    if (is_function(e, "sin")) {
      return pair(e.op(0)).s;
    }
    if (is_function(e, "tan")) {
      const Pair p = pair(e.op(0));
      return p.s / p.c;
    }
    return e.is_equal(GiNaC::Pi) ? pi_generator() : e.map(*this);
  }

 private:
  [[nodiscard]] Pair pair(const ex& argument) const {
    const Phase phase = phase_of(argument);
    Pair result = quarter_turns(phase.half_turns * 2);
    for (const auto& [monomial, coefficient] : phase.terms) {
      result = sum_of_angles(result, multiple(monomial, coefficient));
    }
    return result;
  }

  [[nodiscard]] static Pair quarter_turns(const numeric& count) {
    switch (GiNaC::mod(count, 4).to_int()) {
      case 0:
        return {1, 0};
      case 1:
        return {0, 1};
      case 2:
        return {-1, 0};
      default:
        return {0, -1};
    }
  }

  // cos and sin of coefficient * monomial, a whole multiple of one generator's angle.
  [[nodiscard]] Pair multiple(const ex& monomial, const numeric& coefficient) const {
    for (const Circle& circle : circles_) {
      const ex ratio = coefficient * monomial / circle.angle;
      if (ratio.info(GiNaC::info_flags::integer)) {
        const int count = ex_to<numeric>(ratio).to_int();
        Pair result{1, 0};
        for (int i = 0; i < std::abs(count); ++i) {
          result = sum_of_angles(result, {circle.c, count > 0 ? circle.s : -circle.s});
          result.c = reduce_square(result.c, circle.c, circle.s);
          result.s = reduce_square(result.s, circle.c, circle.s);
        }
        return result;
      }
    }
    throw OutsideField("the phase " + plain(coefficient * monomial) + " was not announced to the field");
  }

  const std::vector<Circle>& circles_;
};

}  // namespace

TrigField::TrigField(const std::vector<ex>& expressions) {
  std::map<ex, numeric, GiNaC::ex_is_less>
      denominators;  // monomial -> common denominator of its coefficients
  const auto announce = [&](const ex& argument) {
    for (const auto& [monomial, coefficient] : phase_of(argument).terms) {
      const auto [place, fresh] = denominators.try_emplace(monomial, coefficient.denom());
      if (!fresh) {
        place->second = GiNaC::lcm(place->second, coefficient.denom());
      }
    }
  };
  for (const ex& expression : expressions) {
    visit_trigonometric(expression, announce);
  }
  for (const auto& [monomial, denominator] : denominators) {
    const std::string number = std::to_string(circles_.size());
    circles_.push_back({monomial / denominator, GiNaC::symbol("c" + number), GiNaC::symbol("s" + number)});
  }
}

ex TrigField::to_generators(const ex& expression) const {
  ToGenerators map(circles_);
  return map(expression);
}

ex TrigField::reduce(const ex& polynomial) const {
  ex result = polynomial.expand();
  for (const Circle& circle : circles_) {
    result = reduce_square(result, circle.c, circle.s);
  }
  return result;
}

bool TrigField::is_zero(const ex& expression) const {
  if (expression.is_zero()) {
    return true;
  }
  if (const auto symbol = linear_symbol(expression)) {
    // Many small identities for a large one.
    const Linear parts = linear_parts(expression, *symbol);
    return is_zero(parts.slope) && is_zero(parts.constant);
  }
  const ex fraction = to_generators(expression).numer_denom();
  if (reduce(fraction.op(1)).is_zero()) {
    throw OutsideField("the expression divides by something that is identically zero");
  }
  return reduce(fraction.op(0)).is_zero();
}

ex TrigField::from_generators(const ex& expression) const {
  GiNaC::exmap back{{pi_generator(), GiNaC::Pi}};
  for (const Circle& circle : circles_) {
    back[circle.c] = GiNaC::cos(circle.angle);
    back[circle.s] = GiNaC::sin(circle.angle);
  }
  return expression.subs(back, GiNaC::subs_options::no_pattern);
}

}  // namespace stickslip::symbolic
