#include "symbolic/algebra/signs.hpp"

#include <map>
#include <utility>

#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/hypotheses.hpp"
#include "symbolic/algebra/normal_form.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;

// Whether the expression is zero at omega = root, where the factor is linear in omega: sin(omega1*Pi/omega)
// and omega - omega1 are no polynomials in common quantities.
bool vanishes_at_root_in_omega(const ex& expression, const ex& factor) {
  const ex omega = symbol("omega");
  const ex slope = factor.coeff(omega, 1);
  if (!factor.is_polynomial(omega) || factor.degree(omega) != 1 || slope.has(omega)) {
    return false;
  }
  try {
    return expression.subs(omega == -factor.coeff(omega, 0) / slope).normal().is_zero();
  } catch (const GiNaC::pole_error&) {
    return false;
  }
}

// Whether the expression is certainly not zero at some zero of the factor, which is sought where the factor
// is linear in a symbol.
bool differs_at_a_root(const ex& expression, const ex& factor) {
  for (const ex& symbol : symbols_of(factor)) {
    if (!factor.is_polynomial(symbol) || factor.degree(symbol) != 1) {
      continue;
    }
    BallValues values;
    int next = 0;
    for (const ex& other : symbols_of(GiNaC::lst{expression, factor})) {
      values[other] = Ball(7 + 2 * next++) / Ball(10);
    }
    values[symbol] = evaluate(-factor.coeff(symbol, 0) / factor.coeff(symbol, 1), values);
    if (evaluate(expression, values).is_nonzero()) {
      return true;
    }
  }
  return false;
}

bool shows_that_it_vanishes(const ex& expression, const ex& factor) {
  if (differs_at_a_root(in_frequencies(expression), in_frequencies(factor).expand())) {
    return false;
  }
  if (vanishes_at_root_in_omega(expression, factor)) {
    return true;
  }
  const ex a = in_frequencies(expression);
  const ex b = in_frequencies(factor);
  const TrigField field({a, b});
  const Polynomial multiple = field.fraction(a).numerator;
  const Polynomial divisor = field.fraction(b).numerator;
  return divides(divisor, multiple) || divides(divisor, field.reduced(pow(multiple, 2)));
}

}  // namespace

bool vanishes_with(const ex& expression, const ex& factor) {
  // Every claim of a chain asks the same.
  using Question = std::pair<ex, ex>;
  const auto before = [](const Question& a, const Question& b) {
    const int first = a.first.compare(b.first);
    return first < 0 || (first == 0 && a.second.compare(b.second) < 0);
  };
  static std::map<Question, bool, decltype(before)> known(before);
  const auto found = known.find({expression, factor});
  return found != known.end()
             ? found->second
             : known.emplace(Question{expression, factor}, shows_that_it_vanishes(expression, factor))
                   .first->second;
}

}  // namespace stickslip::symbolic::algebra
