#include "symbolic/algebra/symbols.hpp"

#include <cstdlib>
#include <map>
#include <sstream>

#include "core/error.hpp"
#include "model/parameters.hpp"

namespace stickslip::symbolic::algebra {

using GiNaC::ex;

ex symbol(const std::string& name) {
  static std::map<std::string, GiNaC::symbol> known;
  return known.try_emplace(name, name).first->second;
}

ex in_frequencies(const ex& expression) {
  static const GiNaC::exmap substitution = [] {
    const ex omega1 = symbol("omega1");
    const ex omega2 = symbol("omega2");
    const ex chi = model::chi_from_frequencies<ex>(omega1, omega2);
    return GiNaC::exmap{{symbol("chi"), chi},
                        {symbol("eta"), model::eta_from_frequencies<ex>(omega1, omega2)},
                        {symbol("lambda1"), model::lambda<ex>(chi, omega1).normal()},
                        {symbol("lambda2"), model::lambda<ex>(chi, omega2).normal()}};
  }();
  return expression.subs(substitution, GiNaC::subs_options::no_pattern);
}

namespace {

using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

Ball integer_power(const Ball& base, long exponent) {
  Ball result;
  arb_pow_ui(result.raw(), base.raw(), static_cast<unsigned long>(std::labs(exponent)),
             WorkingPrecision::bits());
  return exponent >= 0 ? result : Ball(1) / result;
}

Ball evaluate_power(const ex& e, const BallValues& values) {
  const Ball base = evaluate(e.op(0), values);
  const ex exponent = e.op(1);
  if (exponent.info(GiNaC::info_flags::integer)) {
    return integer_power(base, ex_to<numeric>(exponent).to_long());
  }
  const ex twice = 2 * exponent;
  if (twice.info(GiNaC::info_flags::integer)) {
    return integer_power(sqrt(base), ex_to<numeric>(twice).to_long());
  }
  throw InternalError("the power " + plain(e) + " cannot be evaluated in balls");
}

Ball evaluate_function(const ex& e, const BallValues& values) {
  const std::string name = ex_to<GiNaC::function>(e).get_name();
  const Ball argument = evaluate(e.op(0), values);
  if (name == "cos") {
    return cos(argument);
  }
  if (name == "sin") {
    return sin(argument);
  }
  if (name == "tan") {
    return tan(argument);
  }
  throw InternalError("the function " + name + " cannot be evaluated in balls");
}

}  // namespace

Ball evaluate(const ex& e, const BallValues& values) {
  if (is_a<numeric>(e) && e.info(GiNaC::info_flags::rational)) {
    return Ball(to_rational(ex_to<numeric>(e)));
  }
  if (e.is_equal(GiNaC::Pi)) {
    return Ball::pi();
  }
  if (is_a<GiNaC::symbol>(e)) {
    const auto found = values.find(e);
    if (found == values.end()) {
      throw InternalError("the symbol " + plain(e) + " has no value");
    }
    return found->second;
  }
  if (is_a<GiNaC::add>(e)) {
    Ball sum(0);
    for (const ex& term : e) {
      sum += evaluate(term, values);
    }
    return sum;
  }
  if (is_a<GiNaC::mul>(e)) {
    Ball product(1);
    for (const ex& factor : e) {
      product *= evaluate(factor, values);
    }
    return product;
  }
  if (is_a<GiNaC::power>(e)) {
    return evaluate_power(e, values);
  }
  if (is_a<GiNaC::function>(e)) {
    return evaluate_function(e, values);
  }
  throw InternalError("the expression " + plain(e) + " cannot be evaluated in balls");
}

Rational to_rational(const numeric& number) {
  if (number.is_integer() && abs(number) < 1000000) {
    return Rational(number.to_long());
  }
  const auto integer = [](const numeric& n) { return mpz_class(plain(n), 10); };
  Rational result(integer(number.numer()), integer(number.denom()));
  result.canonicalize();
  return result;
}

std::string plain(const ex& e) {
  std::ostringstream out;
  out << e;
  return out.str();
}

GiNaC::exset symbols_of(const ex& expression) {
  GiNaC::exset result;
  for (auto it = expression.preorder_begin(); it != expression.preorder_end(); ++it) {
    if (is_a<GiNaC::symbol>(*it)) {
      result.insert(*it);
    }
  }
  return result;
}

}  // namespace stickslip::symbolic::algebra
