#include "symbolic/typeset/polynomial.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/error.hpp"

namespace stickslip::symbolic::typeset {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

using Variables = std::map<ex, std::size_t, GiNaC::ex_is_less>;

bool is_trigonometric(const Alphabet& alphabet, std::size_t i) {
  return alphabet.atoms[i].kind == Atom::Kind::trigonometric;
}

Variables index(const Alphabet& alphabet) {
  Variables result;
  for (std::size_t i = 0; i < alphabet.variables.size(); ++i) {
    result.emplace(alphabet.variables[i], i);
  }
  return result;
}

void multiply(Term& term, const ex& factor, const Variables& variables) {
  if (GiNaC::is_a<numeric>(factor)) {
    term.coefficient *= GiNaC::ex_to<numeric>(factor);
    return;
  }
  const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
  const auto variable = variables.find(is_power ? factor.op(0) : factor);
  if (variable == variables.end()) {
    throw InternalError("a polynomial to be printed holds something that is not a variable");
  }
  term.degrees[variable->second] += is_power ? GiNaC::ex_to<numeric>(factor.op(1)).to_int() : 1;
}

Term read_term(const ex& product, const Variables& variables) {
  Term term{Degrees(variables.size()), 1};
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    for (const ex& factor : product) {
      multiply(term, factor, variables);
    }
  } else {
    multiply(term, product, variables);
  }
  return term;
}

bool is_number(const Polynomial& polynomial) {
  return polynomial.size() == 1 && std::all_of(polynomial[0].degrees.begin(), polynomial[0].degrees.end(),
                                               [](int degree) { return degree == 0; });
}

// Divides by the content, which gets the sign of the leading term.
void make_primitive(Polynomial& polynomial) {
  numeric numerators = 0;
  numeric denominators = 1;
  for (const Term& term : polynomial) {
    numerators = gcd(numerators, term.coefficient.numer());
    denominators = lcm(denominators, term.coefficient.denom());
  }
  const numeric content = numerators / denominators * polynomial[0].coefficient.csgn();
  for (Term& term : polynomial) {
    term.coefficient /= content;
  }
}

Degrees take_monomial(Polynomial& polynomial) {
  Degrees common = polynomial[0].degrees;
  for (const Term& term : polynomial) {
    std::transform(common.begin(), common.end(), term.degrees.begin(), common.begin(),
                   [](int a, int b) { return std::min(a, b); });
  }
  for (Term& term : polynomial) {
    std::transform(term.degrees.begin(), term.degrees.end(), common.begin(), term.degrees.begin(),
                   std::minus<>());
  }
  return common;
}

ex exact_quotient(const ex& dividend, const ex& divisor) {
  ex quotient;
  if (!divide(dividend, divisor, quotient)) {
    throw InternalError("a polynomial to be printed is not divisible by its own factor");
  }
  return quotient;
}

bool is_small(const Polynomial& polynomial, const Alphabet& alphabet) {
  return polynomial.size() <= most_terms_factored || collect_trigonometric(polynomial, alphabet).size() == 1;
}

// What divides all coefficients of the products of cos, sin, tan.
ex trigonometric_content(const Polynomial& polynomial, const Alphabet& alphabet) {
  ex content = 0;
  for (const auto& [degrees, coefficient] : collect_trigonometric(polynomial, alphabet)) {
    content = gcd(content, to_expression(coefficient, alphabet));
  }
  return content;
}

void append_sum(const ex& expression, const Alphabet& alphabet, int exponent, Factors& result) {
  Polynomial sum = to_polynomial(expression, alphabet);
  if (!is_number(sum)) {
    make_primitive(sum);
    result.sums.emplace_back(std::move(sum), exponent);
  }
}

void append_product(const ex& product, const Alphabet& alphabet, int exponent, Factors& result) {
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    for (const ex& factor : product) {
      append_product(factor, alphabet, exponent, result);
    }
  } else if (GiNaC::is_a<GiNaC::power>(product)) {
    const int power = GiNaC::ex_to<numeric>(product.op(1)).to_int();
    append_product(product.op(0), alphabet, exponent * power, result);
  } else {
    append_sum(product, alphabet, exponent, result);
  }
}

// The variable in which the polynomial is linear with the fewest terms; none: nullopt.
std::optional<std::size_t> linear_variable(const Polynomial& polynomial) {
  std::optional<std::size_t> best;
  std::ptrdiff_t fewest = std::ssize(polynomial) + 1;
  for (std::size_t i = 0; i < polynomial[0].degrees.size(); ++i) {
    const auto degree = [i](const Term& term) { return term.degrees[i]; };
    const auto terms = std::ranges::count(polynomial, 1, degree);
    if (terms > 0 && terms < fewest &&
        std::ranges::count(polynomial, 0, degree) + terms == std::ssize(polynomial)) {
      best = i;
      fewest = terms;
    }
  }
  return best;
}

// a x + b is irreducible once it is divided by gcd(a, b): the usual case, and much faster than factor().
void append_factors(const ex& expression, const Alphabet& alphabet, Factors& result) {
  const Polynomial polynomial = to_polynomial(expression, alphabet);
  if (is_number(polynomial)) {
    return;
  }
  if (const auto linear = linear_variable(polynomial)) {
    const ex& x = alphabet.variables[*linear];
    const ex expanded = expression.expand();
    const ex divisor = gcd(expanded.coeff(x, 1), expanded.coeff(x, 0));
    append_sum(exact_quotient(expanded, divisor), alphabet, 1, result);
    append_factors(divisor, alphabet, result);
  } else if (is_small(polynomial, alphabet)) {
    append_product(factor(expression), alphabet, 1, result);
  } else {
    append_sum(expression, alphabet, 1, result);
  }
}

// f(-x), primitive; empty if that is ±f.
Polynomial conjugate(Polynomial polynomial, std::size_t variable) {
  const auto parity = [variable](const Term& term) { return term.degrees[variable] % 2; };
  const int first = parity(polynomial[0]);
  if (std::all_of(polynomial.begin(), polynomial.end(), [&](const Term& t) { return parity(t) == first; })) {
    return {};
  }
  for (Term& term : polynomial) {
    term.coefficient *= parity(term) == first ? 1 : -1;
  }
  return polynomial;
}

bool equal(const Term& a, const Term& b) {
  return a.degrees == b.degrees && a.coefficient.is_equal(b.coefficient);
}

void join_conjugates(Factors& factors, const Alphabet& alphabet) {
  auto& sums = factors.sums;
  for (std::size_t variable = 0; variable < alphabet.atoms.size(); ++variable) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const Polynomial wanted = conjugate(sums[i].first, variable);
      const auto partner = std::find_if(sums.begin(), sums.end(), [&](const auto& other) {
        return other.second == sums[i].second &&
               std::equal(other.first.begin(), other.first.end(), wanted.begin(), wanted.end(), equal);
      });
      if (partner != sums.end()) {
        const ex product = to_expression(sums[i].first, alphabet) * to_expression(partner->first, alphabet);
        sums[i].first = to_polynomial(product, alphabet);
        sums.erase(partner);
        i = static_cast<std::size_t>(-1);  // start again: the product may have a partner too
      }
    }
  }
}

numeric unit_of(const Polynomial& polynomial, const Factors& factors) {
  numeric unit = polynomial[0].coefficient;
  for (const auto& [sum, exponent] : factors.sums) {
    unit /= GiNaC::pow(sum[0].coefficient, numeric(exponent));
  }
  return unit;
}

}  // namespace

bool leads(const Degrees& a, const Degrees& b, const Alphabet& alphabet) {
  const bool has_pi = !alphabet.atoms.empty() && alphabet.atoms[0].kind == Atom::Kind::pi;
  if (has_pi && a[0] != b[0]) {
    return a[0] > b[0];
  }
  const int total_a = std::accumulate(a.begin(), a.end(), 0);
  const int total_b = std::accumulate(b.begin(), b.end(), 0);
  return total_a != total_b ? total_a > total_b : a > b;
}

Polynomial to_polynomial(const ex& expression, const Alphabet& alphabet) {
  const Variables variables = index(alphabet);
  const ex expanded = expression.expand();
  Polynomial result;
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const ex& term : expanded) {
      result.push_back(read_term(term, variables));
    }
  } else if (!expanded.is_zero()) {
    result.push_back(read_term(expanded, variables));
  }
  std::sort(result.begin(), result.end(),
            [&](const Term& a, const Term& b) { return leads(a.degrees, b.degrees, alphabet); });
  return result;
}

ex to_expression(const Polynomial& polynomial, const Alphabet& alphabet) {
  GiNaC::exvector terms;
  for (const Term& term : polynomial) {
    GiNaC::exvector factors{term.coefficient};
    for (std::size_t i = 0; i < term.degrees.size(); ++i) {
      factors.push_back(pow(alphabet.variables[i], term.degrees[i]));
    }
    terms.push_back(GiNaC::mul(factors));
  }
  return GiNaC::add(terms);
}

std::vector<std::pair<Degrees, Polynomial>> collect_trigonometric(const Polynomial& polynomial,
                                                                  const Alphabet& alphabet) {
  const auto before = [&](const Degrees& a, const Degrees& b) { return leads(a, b, alphabet); };
  std::map<Degrees, Polynomial, decltype(before)> parts(before);
  for (const Term& term : polynomial) {
    Degrees trigonometric(term.degrees.size());
    Term rest = term;
    for (std::size_t i = 0; i < term.degrees.size(); ++i) {
      if (is_trigonometric(alphabet, i)) {
        std::swap(trigonometric[i], rest.degrees[i]);
      }
    }
    parts[trigonometric].push_back(rest);
  }
  return {parts.begin(), parts.end()};
}

Factors factorise(const Polynomial& polynomial, const Alphabet& alphabet) {
  Polynomial rest = polynomial;
  make_primitive(rest);
  Factors result;
  result.monomial = take_monomial(rest);
  if (!is_number(rest)) {
    const ex whole = to_expression(rest, alphabet);
    const ex content = trigonometric_content(rest, alphabet);
    append_factors(content, alphabet, result);
    append_factors(exact_quotient(whole, content), alphabet, result);
  }
  join_conjugates(result, alphabet);
  result.unit = unit_of(polynomial, result);
  return result;
}

}  // namespace stickslip::symbolic::typeset
