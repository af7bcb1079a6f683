#include "symbolic/algebra/hypotheses.hpp"

#include <map>
#include <utility>

#include "symbolic/algebra/normal_form.hpp"
#include "symbolic/algebra/symbols.hpp"
#include "symbolic/typeset/latex.hpp"

namespace stickslip::symbolic::algebra {

using namespace typeset;

namespace {

using GiNaC::ex;
using GiNaC::is_a;

// Every base of a negative power inside e, and cos(x) for every tan(x).
void collect_denominators(const ex& e, GiNaC::exset& found) {
  if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::negative)) {
    found.insert(e.op(0));
  }
  if (is_a<GiNaC::function>(e) && GiNaC::ex_to<GiNaC::function>(e).get_name() == "tan") {
    found.insert(GiNaC::cos(e.op(0)));
  }
  for (const ex& operand : e) {
    collect_denominators(operand, found);
  }
}

bool is_known_positive(const ex& symbol) {
  static const GiNaC::exset positive{::stickslip::symbolic::algebra::symbol("omega"),
                                     ::stickslip::symbolic::algebra::symbol("us"),
                                     ::stickslip::symbolic::algebra::symbol("ur")};
  return positive.contains(symbol);
}

// Whether a polynomial in omega1, omega2 and positive symbols has no zero on the domain.
bool cannot_vanish(const ex& factor) {
  static const GiNaC::symbol a("a"), b("b");
  const ex numerator = factor
                           .subs(GiNaC::exmap{{symbol("omega1"), a / (1 + a)}, {symbol("omega2"), 1 + b}},
                                 GiNaC::subs_options::no_pattern)
                           .numer()
                           .expand();
  int sign = 0;
  const auto agrees = [&](const ex& term) {
    ex coefficient = 1;
    for (const ex& part : is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term})) {
      const ex base = is_a<GiNaC::power>(part) ? part.op(0) : part;
      if (is_a<GiNaC::numeric>(part)) {
        coefficient *= part;
      } else if (!base.is_equal(a) && !base.is_equal(b) && !base.is_equal(GiNaC::Pi) &&
                 !is_known_positive(base)) {
        return false;
      }
    }
    const int here = coefficient.info(GiNaC::info_flags::positive) ? 1 : -1;
    const bool same = sign == 0 || sign == here;
    sign = here;
    return same;
  };
  if (!is_a<GiNaC::add>(numerator)) {
    return !numerator.is_zero() && agrees(numerator);
  }
  for (const ex& term : numerator) {
    if (!agrees(term)) {
      return false;
    }
  }
  return true;
}

std::vector<ex> sorted(const GiNaC::exset& factors) {
  std::map<std::string, ex>
      by_text;  // one of f and -f; the order of a set of expressions is not the same every run
  for (const ex& factor : factors) {
    const std::string plus = text(factor);
    const std::string minus = text(-factor);
    const bool as_it_stands = std::pair(plus.size(), plus) <= std::pair(minus.size(), minus);
    as_it_stands ? by_text.emplace(plus, factor) : by_text.emplace(minus, -factor);
  }
  std::vector<ex> result;
  for (const auto& entry : by_text) {
    result.push_back(entry.second);
  }
  return result;
}

void collect_vanishing(const ex& expression, GiNaC::exset& found) {
  const ex parametrised = in_frequencies(expression);
  const TrigField field({parametrised});
  const Polynomial numerator = field.fraction(parametrised).numerator;
  if (numerator.is_zero()) {
    throw OutsideField(divides_by_zero);
  }
  for (const Factor& generated : factored(numerator).factors) {
    const ex factor = field.expression(generated.base);
    if (!cannot_vanish(factor)) {
      found.insert(factor);
    }
  }
}

}  // namespace

std::vector<ex> vanishing_factors(const ex& expression) {
  GiNaC::exset found;
  collect_vanishing(expression, found);
  return sorted(found);
}

std::vector<ex> hypotheses_of(const std::vector<ex>& expressions) {
  GiNaC::exset denominators;
  for (const ex& expression : expressions) {
    collect_denominators(expression, denominators);
  }
  GiNaC::exset found;
  for (const ex& denominator : denominators) {
    collect_vanishing(denominator, found);
  }
  return sorted(found);
}

}  // namespace stickslip::symbolic::algebra
