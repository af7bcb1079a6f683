#include "proofs/tactics/letters.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "proofs/tactics/polynomials.hpp"
#include "proofs/tactics/text.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;
using GiNaC::ex;

ex Letters::expression(const Term& term) {
  const std::vector<Term>& parts = term.parts();
  switch (term.kind()) {
    case Kind::number:
      return symbolic::algebra::to_ex(term.value());
    case Kind::sum: {
      ex total = 0;
      for (const Term& one : parts) {
        total += expression(one);
      }
      return total;
    }
    case Kind::product:
      return expression(parts[0]) * expression(parts[1]);
    case Kind::power:
      return term.value() == 0 ? ex(1) : pow(expression(parts[0]), symbolic::algebra::to_ex(term.value()));
    case Kind::inverse: {
      const ex below = expression(parts[0]);
      if (below.expand().normal().is_zero()) {
        throw ZeroDivisor("a term divides by what is zero for all values of its variables");
      }
      return 1 / below;
    }
    case Kind::entry:
      if (parts[0].kind() == Kind::matrix) {
        return expression(
            parts[0].parts()[static_cast<std::size_t>(term.row() * parts[0].type().columns + term.column())]);
      }
      return letter(term);
    default:
      return letter(term);
  }
}

std::vector<Letters::Monomial> Letters::monomials(const ex& polynomial) const {
  const ex expanded = polynomial.expand();
  std::vector<Monomial> result;
  const auto add = [&](const ex& term) {
    Monomial monomial{{}, 0};
    ex rest = term;
    for (const GiNaC::symbol& symbol : symbols_) {
      monomial.degrees.push_back(rest.degree(symbol));
      rest = rest.lcoeff(symbol);
    }
    monomial.coefficient = symbolic::algebra::to_rational(GiNaC::ex_to<GiNaC::numeric>(rest));
    result.push_back(monomial);
  };
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    std::for_each(expanded.begin(), expanded.end(), add);
  } else if (!expanded.is_zero()) {
    add(expanded);
  }
  std::sort(result.begin(), result.end(),
            [](const Monomial& a, const Monomial& b) { return a.degrees > b.degrees; });
  return result;
}

Term Letters::term(const ex& polynomial) const {
  std::vector<Term> parts;
  for (const Monomial& monomial : monomials(polynomial)) {
    std::optional<Term> product;
    if (abs(monomial.coefficient) != 1) {
      product = Term(monomial.coefficient);
    }
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (monomial.degrees[i] > 0) {
        const Term factor = monomial.degrees[i] == 1 ? terms_[i] : power(terms_[i], monomial.degrees[i]);
        product = product ? *product * factor : factor;
      }
    }
    const bool negative = monomial.coefficient == -1;
    parts.push_back(!product ? Term(monomial.coefficient) : negative ? -*product : *product);
  }
  return parts.empty() ? Term(0) : parts.size() == 1 ? parts[0] : sum(parts);
}

std::pair<ex, ex> Letters::fraction(const ex& expression) const {
  const ex parts = expression.numer_denom();
  const int sign = monomials(parts.op(1)).front().coefficient < 0 ? -1 : 1;
  return {sign * parts.op(0), sign * parts.op(1)};
}

void Letters::sort() {
  std::vector<std::size_t> order(terms_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return to_string(terms_[a]) < to_string(terms_[b]); });
  std::vector<Term> terms;
  std::vector<GiNaC::symbol> symbols;
  for (const std::size_t i : order) {
    terms.push_back(terms_[i]);
    symbols.push_back(symbols_[i]);
  }
  terms_ = terms;
  symbols_ = symbols;
}

ex Letters::letter(const Term& term) {
  const auto known = std::find(terms_.begin(), terms_.end(), term);
  const auto index = static_cast<std::size_t>(known - terms_.begin());
  if (known == terms_.end()) {
    terms_.push_back(term);
    symbols_.emplace_back();
  }
  return symbols_[index];
}

Factored factored(const ex& numerator, const Letters& letters, std::size_t longest) {
  const ex expanded = numerator.expand();
  std::vector<std::pair<ex, int>> found;
  const auto add = [&](const ex& base, int exponent) {
    const bool negative = letters.monomials(base).front().coefficient < 0;
    found.emplace_back(negative ? ex(-base).expand() : base.expand(), exponent);
  };
  if (expanded.nops() > longest) {
    add(expanded, 1);
  } else {
    const PolynomialRing ring(letters.terms().size());
    try {
      for (const auto& [base, exponent] :
           irreducible_factors(polynomial(ring, letters.monomials(expanded)))) {
        add(tactics::expression(monomials(base), letters), exponent);
      }
    } catch (const std::overflow_error&) {
      add(expanded, 1);
    }
  }
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return to_string(letters.term(a.first)) < to_string(letters.term(b.first));
  });
  Factored result;
  for (const auto& [base, exponent] : found) {
    result.factors.push_back(base);
    result.exponents.push_back(exponent);
    result.product *= pow(base, exponent);
  }
  return result;
}

Term quotient(const Term& a, const Term& b) {
  Letters letters;
  const ex top = letters.expression(a), bottom = letters.expression(b).normal();
  if (bottom.is_zero()) {
    throw KernelError("nothing is divided by 0");
  }
  const auto [above, below] = letters.fraction(top / bottom);
  return letters.term(above) / letters.term(below);
}

}  // namespace stickslip::proofs::tactics
