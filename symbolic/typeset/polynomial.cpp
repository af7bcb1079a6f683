#include "symbolic/typeset/polynomial.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "core/fmpq.hpp"
#include "core/polynomial.hpp"
#include "symbolic/algebra/evaluate.hpp"

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

void sort(Polynomial& polynomial, const Alphabet& alphabet) {
  std::sort(polynomial.begin(), polynomial.end(),
            [&](const Term& a, const Term& b) { return leads(a.degrees, b.degrees, alphabet); });
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

// FLINT's list of factors.
struct Factorisation {
  explicit Factorisation(const PolynomialRing& ring) : context(ring.context()), raw{} {
    fmpq_mpoly_factor_init(raw, context);
  }
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;
  ~Factorisation() { fmpq_mpoly_factor_clear(raw, context); }

  const fmpq_mpoly_ctx_struct * context;
  fmpq_mpoly_factor_t raw;
};

stickslip::Polynomial in_flint(const Polynomial& polynomial, const PolynomialRing& ring) {
  stickslip::Polynomial result(ring);
  for (const auto& [degrees, coefficient] : polynomial) {
    const std::vector<ulong> exponents(degrees.begin(), degrees.end());
    const Fmpq exact(algebra::to_rational(coefficient));
    fmpq_mpoly_push_term_fmpq_ui(result.raw(), exact.raw(), exponents.data(), ring.context());
  }
  fmpq_mpoly_sort_terms(result.raw(), ring.context());
  return result;
}

Polynomial from_flint(const fmpq_mpoly_struct& raw, const PolynomialRing& ring, const Alphabet& alphabet) {
  Polynomial result;
  std::vector<ulong> exponents(ring.generators());
  for (slong i = 0; i < fmpq_mpoly_length(&raw, ring.context()); ++i) {
    Fmpq coefficient;
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), &raw, i, ring.context());
    fmpq_mpoly_get_term_exp_ui(exponents.data(), &raw, i, ring.context());
    result.push_back({Degrees(exponents.begin(), exponents.end()),
                      GiNaC::ex_to<numeric>(algebra::to_ex(coefficient.value()))});
  }
  sort(result, alphabet);
  return result;
}

// The irreducible factors, primitive. FLINT's time does not depend on the order in which symbols were made,
// as that of GiNaC's factor() does. Where it gives up the polynomial is its own factor.
std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& polynomial,
                                                            const Alphabet& alphabet) {
  const PolynomialRing ring(alphabet.variables.size());
  Factorisation found(ring);
  if (fmpq_mpoly_factor(found.raw, in_flint(polynomial, ring).raw(), ring.context()) == 0) {
    return {{polynomial, 1}};
  }
  std::vector<std::pair<Polynomial, int>> result;
  for (slong i = 0; i < found.raw->num; ++i) {
    Polynomial factor = from_flint(found.raw->poly[i], ring, alphabet);
    make_primitive(factor);
    result.emplace_back(std::move(factor), static_cast<int>(fmpz_get_si(found.raw->exp + i)));
  }
  return result;
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
  sort(result, alphabet);
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
  result.sums = irreducible_factors(rest, alphabet);
  join_conjugates(result, alphabet);
  result.unit = unit_of(polynomial, result);
  return result;
}

}  // namespace stickslip::symbolic::typeset
