#include "proofs/tactics/letters.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/fmpq.hpp"
#include "proofs/tactics/text.hpp"

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

// What a term is rational in; of an entry of a matrix that is written out, that entry.
template <class Visit>
void visit_parts(const Term& term, const Visit& visit) {
  if (term.kind() == Kind::entry) {
    const Term& whole = term.parts()[0];
    visit(whole.parts()[static_cast<std::size_t>(term.row() * whole.type().columns + term.column())]);
  } else {
    std::for_each(term.parts().begin(), term.parts().end(), visit);
  }
}

bool is_letter(const Term& term) {
  switch (term.kind()) {
    case Kind::number:
    case Kind::sum:
    case Kind::product:
    case Kind::power:
    case Kind::inverse:
      return false;
    case Kind::entry:
      return term.parts()[0].kind() != Kind::matrix;
    default:
      return true;
  }
}

// By their text first.
using ByText = std::set<std::pair<std::string, Term>>;

void collect(const Term& term, std::set<Term>& seen, ByText& letters) {
  if (!seen.insert(term).second) {
    return;
  }
  if (is_letter(term)) {
    letters.emplace(to_string(term), term);
  } else {
    visit_parts(term, [&](const Term& part) { collect(part, seen, letters); });
  }
}

// The polynomial times what makes its coefficients whole and without a common divisor; that factor's inverse.
Rational take_content(Polynomial& polynomial) {
  mpz_class above = 0, below = 1;
  for (const Monomial& one : monomials(polynomial)) {
    above = gcd(above, one.coefficient.get_num());
    below = lcm(below, one.coefficient.get_den());
  }
  Rational content(above, below);
  content.canonicalize();
  polynomial *= polynomial.ring().constant(1 / content);
  return content;
}

class Factors {
 public:
  explicit Factors(const PolynomialRing& ring) : ring_(ring), raw_{} {
    fmpq_mpoly_factor_init(raw_, ring.context());
  }
  ~Factors() { fmpq_mpoly_factor_clear(raw_, ring_.context()); }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
  [[nodiscard]] fmpq_mpoly_factor_struct * raw() { return raw_; }

 private:
  const PolynomialRing& ring_;
  fmpq_mpoly_factor_t raw_;
};

// The irreducible factors with their exponents, without the constant one; the whole where FLINT gives up.
std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& polynomial) {
  const PolynomialRing& ring = polynomial.ring();
  Factors found(ring);
  if (fmpq_mpoly_factor(found.raw(), polynomial.raw(), ring.context()) == 0) {
    return {{polynomial, 1}};
  }
  std::vector<std::pair<Polynomial, int>> result;
  for (slong k = 0; k < fmpq_mpoly_factor_length(found.raw(), ring.context()); ++k) {
    Polynomial base(ring);
    fmpq_mpoly_factor_get_base(base.raw(), found.raw(), k, ring.context());
    result.emplace_back(base, static_cast<int>(fmpq_mpoly_factor_get_exp_si(found.raw(), k, ring.context())));
  }
  return result;
}

}  // namespace

std::vector<Monomial> monomials(const Polynomial& polynomial) {
  const PolynomialRing& ring = polynomial.ring();
  std::vector<Monomial> result;
  std::vector<ulong> exponents(ring.generators());
  for (slong k = 0; k < fmpq_mpoly_length(polynomial.raw(), ring.context()); ++k) {
    Fmpq coefficient;
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), polynomial.raw(), k, ring.context());
    fmpq_mpoly_get_term_exp_ui(exponents.data(), polynomial.raw(), k, ring.context());
    result.push_back({{exponents.begin(), exponents.end()}, coefficient.value()});
  }
  return result;
}

Polynomial polynomial(const PolynomialRing& ring, const std::vector<Monomial>& monomials) {
  Polynomial sum(ring);
  for (const Monomial& monomial : monomials) {
    const Fmpq coefficient(monomial.coefficient);
    const std::vector<ulong> exponents(monomial.degrees.begin(), monomial.degrees.end());
    fmpq_mpoly_push_term_fmpq_ui(sum.raw(), coefficient.raw(), exponents.data(), ring.context());
  }
  fmpq_mpoly_sort_terms(sum.raw(), ring.context());
  fmpq_mpoly_combine_like_terms(sum.raw(), ring.context());
  return sum;
}

Letters::Letters(const std::vector<Term>& terms) {
  std::set<Term> seen;
  ByText letters;
  for (const Term& term : terms) {
    collect(term, seen, letters);
  }
  for (const auto& [name, letter] : letters) {
    places_.emplace(letter, terms_.size());
    terms_.push_back(letter);
  }
  ring_ = std::make_unique<Ring>(terms_.size(), 0);
}

Quotient Letters::quotient(const Term& term) const {
  const auto part = [&](std::size_t k) { return quotient(term.parts()[k]); };
  if (is_letter(term)) {
    return ring_->generator(places_.at(term));
  }
  switch (term.kind()) {
    case Kind::number:
      return ring_->number(term.value());
    case Kind::product:
      return part(0) * part(1);
    case Kind::inverse:
      return part(0).inverted();
    case Kind::power: {
      Quotient result = ring_->number(1);
      const Quotient base = part(0);
      const mpz_class exponent = term.value().get_num();
      for (std::size_t bit = mpz_sizeinbase(exponent.get_mpz_t(), 2); bit-- > 0;) {
        result = result * result;
        if (mpz_tstbit(exponent.get_mpz_t(), bit) != 0) {
          result = result * base;
        }
      }
      return result;
    }
    default: {
      Quotient sum = ring_->number(0);
      visit_parts(term, [&](const Term& one) { sum = sum + quotient(one); });
      return sum;
    }
  }
}

Fraction Letters::fraction(const Term& term) const {
  const Quotient whole = quotient(term);
  const Polynomial common = ring_->common_divisor(whole.numerator(), whole.denominator());
  Fraction result{stickslip::quotient(whole.numerator(), common),
                  stickslip::quotient(whole.denominator(), common)};
  const int sign = sgn(leading_coefficient(result.below));
  const Rational below = sign * take_content(result.below);
  result.below *= ring().constant(sign);
  if (!result.above.is_zero()) {
    const Rational factor = take_content(result.above) / below;
    result.above *= ring().constant(factor.get_num());
    result.below *= ring().constant(factor.get_den());
  }
  return result;
}

Term Letters::term(const Polynomial& polynomial) const {
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

Factored factored(const Polynomial& polynomial, const Letters& letters, std::size_t longest) {
  const auto length = fmpq_mpoly_length(polynomial.raw(), letters.ring().context());
  std::vector<std::pair<Polynomial, int>> found =
      length > static_cast<slong>(longest) ? std::vector<std::pair<Polynomial, int>>{{polynomial, 1}}
                                           : irreducible_factors(polynomial);
  for (auto& [base, exponent] : found) {
    take_content(base);
    base *= letters.ring().constant(sgn(leading_coefficient(base)));
  }
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return to_string(letters.term(a.first)) < to_string(letters.term(b.first));
  });
  Factored result{{}, {}, letters.ring().constant(1)};
  for (const auto& [base, exponent] : found) {
    result.factors.push_back(base);
    result.exponents.push_back(exponent);
    for (int k = 0; k < exponent; ++k) {
      result.product *= base;
    }
  }
  return result;
}

Term quotient(const Term& a, const Term& b) {
  const Letters letters({a, b});
  const auto [above, below] = letters.fraction(a / b);
  const Term numerator = letters.term(above), denominator = letters.term(below);
  return denominator == Term(1) ? numerator : numerator / denominator;
}

}  // namespace stickslip::proofs::tactics
