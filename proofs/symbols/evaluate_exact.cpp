#include "proofs/symbols/evaluate_exact.hpp"

#include "proofs/symbols/evaluate.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::proofs::symbols {

using namespace numeric::scalars;

template Value<Exact> evaluate(const Term&, const Lookup<Exact>&);

namespace {

using GiNaC::ex;

template <class S>
S power(const S& base, const ex& exponent) {
  if (!exponent.info(GiNaC::info_flags::integer)) {
    throw NoExactValue("a power is not rational");
  }
  const long n = GiNaC::ex_to<GiNaC::numeric>(exponent).to_long();
  S product(1);
  for (long i = 0; i < std::labs(n); ++i) {
    product *= base;
  }
  return product;
}

// Folds a sum or product.
template <class S, class Function>
S folded(const ex& expression, const Function& value) {
  const bool sum = GiNaC::is_a<GiNaC::add>(expression);
  if (!sum && !GiNaC::is_a<GiNaC::mul>(expression)) {
    throw NoExactValue("an expression is not rational in symbols and trigonometric functions");
  }
  S result(sum ? 0 : 1);
  for (const ex& operand : expression) {
    if (sum) {
      result += value(operand);
    } else {
      result *= value(operand);
    }
  }
  return result;
}

}  // namespace

Exact ExactValues::angle(const ex& expression) {
  if (GiNaC::is_a<GiNaC::numeric>(expression)) {
    return Exact(symbolic::algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>(expression)));
  }
  if (GiNaC::is_a<GiNaC::symbol>(expression)) {
    return scalar_(GiNaC::ex_to<GiNaC::symbol>(expression).get_name());
  }
  if (expression.is_equal(GiNaC::Pi)) {
    return scalar_("pi");
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    const Exact product = power(angle(expression.op(0)), expression.op(1));
    return expression.op(1).info(GiNaC::info_flags::negative) ? Exact(1) / product : product;
  }
  return folded<Exact>(expression, [this](const ex& operand) { return angle(operand); });
}

Rational ExactValues::function(const ex& expression) {
  auto known = sin_cos_.find(expression.op(0));
  if (known == sin_cos_.end()) {
    const auto [sine, cosine] = sin_cos(angle(expression.op(0)));
    known = sin_cos_.emplace(expression.op(0), std::pair(sine.value(), cosine.value())).first;
  }
  const auto& [sine, cosine] = known->second;
  const std::string name = GiNaC::ex_to<GiNaC::function>(expression).get_name();
  if (name == "sin" || name == "cos") {
    return name == "sin" ? sine : cosine;
  }
  if (name != "tan") {
    throw NoExactValue("the function " + name + " is not trigonometric");
  }
  return (Exact(sine) / Exact(cosine)).value();
}

Rational ExactValues::operator()(const ex& expression) {
  if (GiNaC::is_a<GiNaC::numeric>(expression) || GiNaC::is_a<GiNaC::symbol>(expression) ||
      GiNaC::is_a<GiNaC::constant>(expression)) {
    return angle(expression).value();
  }
  if (GiNaC::is_a<GiNaC::function>(expression)) {
    return function(expression);
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    const Rational product = power((*this)(expression.op(0)), expression.op(1));
    return expression.op(1).info(GiNaC::info_flags::negative) ? (Exact(1) / Exact(product)).value() : product;
  }
  return folded<Rational>(expression, [this](const ex& operand) { return (*this)(operand); });
}

}  // namespace stickslip::proofs::symbols
