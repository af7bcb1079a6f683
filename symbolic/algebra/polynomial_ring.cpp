#include "symbolic/algebra/polynomial_ring.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/fmpq.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::symbolic::algebra {

Polynomial PolynomialRing::generator(const GiNaC::ex& symbol) const {
  const auto place = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const GiNaC::ex& known) { return known.is_equal(symbol); });
  if (place == symbols_.end()) {
    throw InternalError("the ring has no symbol " + plain(symbol));
  }
  return stickslip::PolynomialRing::generator(static_cast<std::size_t>(place - symbols_.begin()));
}

Polynomial PolynomialRing::constant(const GiNaC::numeric& rational) const {
  return stickslip::PolynomialRing::constant(to_rational(rational));
}

GiNaC::ex PolynomialRing::expression(const Polynomial& polynomial) const {
  GiNaC::ex sum = 0;
  const slong length = fmpq_mpoly_length(polynomial.raw(), context());
  for (slong i = 0; i < length; ++i) {
    Fmpq coefficient;
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), polynomial.raw(), i, context());
    GiNaC::ex term = to_ex(coefficient.value());
    for (std::size_t k = 0; k < symbols_.size(); ++k) {
      const ulong exponent =
          fmpq_mpoly_get_term_var_exp_ui(polynomial.raw(), i, static_cast<slong>(k), context());
      term *= GiNaC::pow(symbols_[k], GiNaC::numeric(exponent));
    }
    sum += term;
  }
  return sum;
}

Polynomial pow(const Polynomial& base, unsigned long exponent) {
  Polynomial result(base.ring());
  if (fmpq_mpoly_pow_ui(result.raw(), base.raw(), exponent, base.ring().context()) == 0) {
    throw InternalError("a power of a polynomial does not fit into memory");
  }
  return result;
}

bool divides(const Polynomial& divisor, const Polynomial& multiple) {
  if (divisor.is_zero()) {
    return multiple.is_zero();  // FLINT would abort
  }
  Polynomial result(divisor.ring());
  return fmpq_mpoly_divides(result.raw(), multiple.raw(), divisor.raw(), divisor.ring().context()) != 0;
}

Factors factored(const Polynomial& polynomial) {
  const stickslip::PolynomialRing& ring = polynomial.ring();
  fmpq_mpoly_factor_t raw;
  fmpq_mpoly_factor_init(raw, ring.context());
  const bool found = fmpq_mpoly_factor(raw, polynomial.raw(), ring.context()) != 0 &&
                     fmpq_mpoly_factor_make_integral(raw, ring.context()) != 0;
  Factors result;
  Fmpq constant;
  fmpq_mpoly_factor_get_constant_fmpq(constant.raw(), raw, ring.context());
  result.constant = constant.value();
  for (slong i = 0; i < fmpq_mpoly_factor_length(raw, ring.context()); ++i) {
    Factor factor{Polynomial(ring),
                  static_cast<unsigned long>(fmpq_mpoly_factor_get_exp_si(raw, i, ring.context()))};
    fmpq_mpoly_factor_get_base(factor.base.raw(), raw, i, ring.context());
    result.factors.push_back(std::move(factor));
  }
  fmpq_mpoly_factor_clear(raw, ring.context());
  if (!found) {
    throw InternalError("a polynomial was not factored");
  }
  return result;
}

}  // namespace stickslip::symbolic::algebra
