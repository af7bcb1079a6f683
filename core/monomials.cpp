#include "core/monomials.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include "core/fmpq.hpp"

namespace stickslip {

namespace {

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

Rational take_content(Polynomial& polynomial) {
  Fmpq content;
  fmpq_mpoly_content(content.raw(), polynomial.raw(), polynomial.ring().context());
  fmpq_mpoly_scalar_div_fmpq(polynomial.raw(), polynomial.raw(), content.raw(), polynomial.ring().context());
  return content.value();
}

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

}  // namespace stickslip
