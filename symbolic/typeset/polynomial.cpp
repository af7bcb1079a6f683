#include "symbolic/typeset/polynomial.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "symbolic/algebra/symbols.hpp"

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

void multiply(Monomial& term, const ex& factor, const Variables& variables) {
  if (GiNaC::is_a<numeric>(factor)) {
    term.coefficient *= algebra::to_rational(GiNaC::ex_to<numeric>(factor));
    return;
  }
  const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
  const auto variable = variables.find(is_power ? factor.op(0) : factor);
  if (variable == variables.end()) {
    throw InternalError("a polynomial to be printed holds something that is not a variable");
  }
  term.degrees[variable->second] += is_power ? GiNaC::ex_to<numeric>(factor.op(1)).to_int() : 1;
}

Monomial read_term(const ex& product, const Variables& variables) {
  Monomial term{Degrees(variables.size()), 1};
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    for (const ex& factor : product) {
      multiply(term, factor, variables);
    }
  } else {
    multiply(term, product, variables);
  }
  return term;
}

// Whether a comes before b in a polynomial.
bool leads(const Degrees& a, const Degrees& b, const Alphabet& alphabet) {
  const bool has_pi = !alphabet.atoms.empty() && alphabet.atoms[0].kind == Atom::Kind::pi;
  if (has_pi && a[0] != b[0]) {
    return a[0] > b[0];
  }
  const int total_a = std::accumulate(a.begin(), a.end(), 0);
  const int total_b = std::accumulate(b.begin(), b.end(), 0);
  return total_a != total_b ? total_a > total_b : a > b;
}

void sort(Polynomial& polynomial, const Alphabet& alphabet) {
  std::sort(polynomial.begin(), polynomial.end(),
            [&](const Monomial& a, const Monomial& b) { return leads(a.degrees, b.degrees, alphabet); });
}

// Primitive, with a positive leading term.
Polynomial primitive(stickslip::Polynomial polynomial, const Alphabet& alphabet) {
  take_content(polynomial);
  Polynomial result = monomials(polynomial);
  sort(result, alphabet);
  const int sign = sgn(result[0].coefficient);
  for (Monomial& term : result) {
    term.coefficient *= sign;
  }
  return result;
}

Degrees take_monomial(Polynomial& polynomial) {
  Degrees common = polynomial[0].degrees;
  for (const Monomial& term : polynomial) {
    std::transform(common.begin(), common.end(), term.degrees.begin(), common.begin(),
                   [](int a, int b) { return std::min(a, b); });
  }
  for (Monomial& term : polynomial) {
    std::transform(term.degrees.begin(), term.degrees.end(), common.begin(), term.degrees.begin(),
                   std::minus<>());
  }
  return common;
}

// f(-x), primitive; empty if that is ±f.
Polynomial conjugate(Polynomial polynomial, std::size_t variable) {
  const auto parity = [variable](const Monomial& term) { return term.degrees[variable] % 2; };
  const int first = parity(polynomial[0]);
  if (std::all_of(polynomial.begin(), polynomial.end(),
                  [&](const Monomial& t) { return parity(t) == first; })) {
    return {};
  }
  for (Monomial& term : polynomial) {
    term.coefficient *= parity(term) == first ? 1 : -1;
  }
  return polynomial;
}

void join_conjugates(Factors& factors, const PolynomialRing& ring, const Alphabet& alphabet) {
  auto& sums = factors.sums;
  for (std::size_t variable = 0; variable < alphabet.atoms.size(); ++variable) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const Polynomial wanted = conjugate(sums[i].first, variable);
      const auto partner = std::find_if(sums.begin(), sums.end(), [&](const auto& other) {
        return other.second == sums[i].second && other.first == wanted;
      });
      if (partner != sums.end()) {
        stickslip::Polynomial product = polynomial(ring, sums[i].first);
        product *= polynomial(ring, partner->first);
        sums[i].first = primitive(product, alphabet);
        sums.erase(partner);
        i = static_cast<std::size_t>(-1);  // start again: the product may have a partner too
      }
    }
  }
}

}  // namespace

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
  sort(result, alphabet);
  return result;
}

Fraction to_fraction(const Monomial& monomial, const Alphabet& alphabet) {
  std::vector<Power> above, below;
  for (std::size_t i = 0; i < monomial.degrees.size(); ++i) {
    if (const int degree = monomial.degrees[i]; degree != 0) {
      (degree > 0 ? above : below).push_back({alphabet.atoms[i], {}, std::abs(degree)});
    }
  }
  return times(monomial.coefficient, std::move(above), std::move(below));
}

std::vector<std::pair<Degrees, Polynomial>> collect_trigonometric(const Polynomial& polynomial,
                                                                  const Alphabet& alphabet) {
  const auto before = [&](const Degrees& a, const Degrees& b) { return leads(a, b, alphabet); };
  std::map<Degrees, Polynomial, decltype(before)> parts(before);
  for (const Monomial& term : polynomial) {
    Degrees trigonometric(term.degrees.size());
    Monomial rest = term;
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
  Factors result;
  Polynomial rest = polynomial;
  result.monomial = take_monomial(rest);
  // FLINT's time does not depend on the order in which symbols were made, as that of GiNaC's factor() does.
  const PolynomialRing ring(alphabet.variables.size());
  for (const auto& [factor, exponent] : irreducible_factors(stickslip::polynomial(ring, rest))) {
    result.sums.emplace_back(primitive(factor, alphabet), exponent);
  }
  join_conjugates(result, ring, alphabet);
  result.unit = polynomial[0].coefficient;
  for (const auto& [sum, exponent] : result.sums) {
    for (int k = 0; k < exponent; ++k) {
      result.unit /= sum[0].coefficient;
    }
  }
  return result;
}

}  // namespace stickslip::symbolic::typeset
