#include "symbolic/algebra/normal_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/fraction.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

bool is_function(const ex& e, const char * name) {
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

// Every s before its c, which makes the relations a Gröbner basis; then the symbols by name, and π.
std::vector<ex> generators(const std::vector<Circle>& circles, const std::vector<ex>& expressions) {
  std::vector<ex> result;
  for (const Circle& circle : circles) {
    result.push_back(circle.s);
    result.push_back(circle.c);
  }
  std::map<std::string, ex> symbols;
  for (const ex& expression : expressions) {
    for (const ex& symbol : symbols_of(expression)) {
      symbols.emplace(plain(symbol), symbol);
    }
  }
  for (const auto& entry : symbols) {
    result.push_back(entry.second);
  }
  result.push_back(pi_generator());
  return result;
}

}  // namespace

const char * const divides_by_zero = "the expression divides by something that is identically zero";

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
  ring_ = std::make_unique<PolynomialRing>(generators(circles_, expressions));
  for (const Circle& circle : circles_) {
    Polynomial relation = pow(ring_->generator(circle.c), 2);
    relation += pow(ring_->generator(circle.s), 2);
    relation += ring_->constant(-1);
    relations_.push_back(std::move(relation));
  }
}

bool TrigField::is_zero(const ex& expression) const {
  return fraction(expression).numerator.is_zero();
}

Fraction TrigField::fraction(const ex& expression) const {
  try {
    return over_one_denominator(ToGenerators(circles_)(expression), *ring_, relations_);
  } catch (const GiNaC::pole_error&) {  // terms cancelled already when they were put into generators
    throw OutsideField(divides_by_zero);
  }
}

Polynomial TrigField::reduced(const Polynomial& polynomial) const {
  return remainder(polynomial, relations_);
}

ex TrigField::expression(const Polynomial& polynomial) const {
  GiNaC::exmap back{{pi_generator(), GiNaC::Pi}};
  for (const Circle& circle : circles_) {
    back[circle.c] = GiNaC::cos(circle.angle);
    back[circle.s] = GiNaC::sin(circle.angle);
  }
  return ring_->expression(polynomial).subs(back, GiNaC::subs_options::no_pattern);
}

}  // namespace stickslip::symbolic::algebra
