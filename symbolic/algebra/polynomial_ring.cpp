#include "symbolic/algebra/polynomial_ring.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/fmpq.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::symbolic::algebra {

PolynomialRing::PolynomialRing(const std::vector<GiNaC::ex>& symbols) : symbols_(symbols), context_{} {
  fmpq_mpoly_ctx_init(context_, static_cast<slong>(symbols.size()), ORD_LEX);
}

PolynomialRing::~PolynomialRing() {
  fmpq_mpoly_ctx_clear(context_);
}

Polynomial PolynomialRing::generator(const GiNaC::ex& symbol) const {
  const auto place = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const GiNaC::ex& known) { return known.is_equal(symbol); });
  if (place == symbols_.end()) {
    throw InternalError("the ring has no symbol " + plain(symbol));
  }
  Polynomial result(*this);
  fmpq_mpoly_gen(result.raw(), place - symbols_.begin(), context_);
  return result;
}

Polynomial PolynomialRing::constant(const GiNaC::numeric& rational) const {
  const Fmpq value(to_rational(rational));
  Polynomial result(*this);
  fmpq_mpoly_set_fmpq(result.raw(), value.raw(), context_);
  return result;
}

GiNaC::ex PolynomialRing::expression(const Polynomial& polynomial) const {
  GiNaC::ex sum = 0;
  const slong length = fmpq_mpoly_length(polynomial.raw(), context_);
  for (slong i = 0; i < length; ++i) {
    Fmpq coefficient;
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), polynomial.raw(), i, context_);
    GiNaC::ex term = to_ex(coefficient.value());
    for (std::size_t k = 0; k < symbols_.size(); ++k) {
      const ulong exponent =
          fmpq_mpoly_get_term_var_exp_ui(polynomial.raw(), i, static_cast<slong>(k), context_);
      term *= GiNaC::pow(symbols_[k], GiNaC::numeric(exponent));
    }
    sum += term;
  }
  return sum;
}

Polynomial::Polynomial(const PolynomialRing& ring) : ring_(&ring), raw_{} {
  fmpq_mpoly_init(raw_, ring.context());
}

Polynomial::Polynomial(const Polynomial& other) : Polynomial(*other.ring_) {
  fmpq_mpoly_set(raw_, other.raw_, ring_->context());
}

Polynomial::Polynomial(Polynomial&& other) noexcept : Polynomial(*other.ring_) {
  fmpq_mpoly_swap(raw_, other.raw_, ring_->context());
}

Polynomial& Polynomial::operator=(Polynomial other) noexcept {
  std::swap(ring_, other.ring_);
  std::swap(raw_[0], other.raw_[0]);
  return *this;
}

Polynomial::~Polynomial() {
  fmpq_mpoly_clear(raw_, ring_->context());
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  fmpq_mpoly_add(raw_, raw_, other.raw_, ring_->context());
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) {
  fmpq_mpoly_mul(raw_, raw_, other.raw_, ring_->context());
  return *this;
}

bool Polynomial::is_zero() const {
  return fmpq_mpoly_is_zero(raw_, ring_->context()) != 0;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpq_mpoly_equal(a.raw(), b.raw(), a.ring().context()) != 0;
}

Polynomial pow(const Polynomial& base, unsigned long exponent) {
  Polynomial result(base.ring());
  if (fmpq_mpoly_pow_ui(result.raw(), base.raw(), exponent, base.ring().context()) == 0) {
    throw InternalError("a power of a polynomial does not fit into memory");
  }
  return result;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring());
  if (fmpq_mpoly_gcd(result.raw(), a.raw(), b.raw(), a.ring().context()) == 0) {
    throw InternalError("the greatest common divisor of two polynomials was not found");
  }
  return result;
}

Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring());
  if (b.is_zero() || fmpq_mpoly_divides(result.raw(), a.raw(), b.raw(), a.ring().context()) == 0) {
    throw InternalError("a polynomial is not divisible by another");
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

Polynomial remainder(const Polynomial& a, const std::vector<Polynomial>& divisors) {
  std::vector<Polynomial> quotients(divisors.size(), Polynomial(a.ring()));
  std::vector<fmpq_mpoly_struct *> into, by;
  for (std::size_t i = 0; i < divisors.size(); ++i) {
    into.push_back(quotients[i].raw());
    by.push_back(const_cast<fmpq_mpoly_struct *>(divisors[i].raw()));  // FLINT reads it only
  }
  Polynomial result(a.ring());
  fmpq_mpoly_divrem_ideal(into.data(), result.raw(), a.raw(), by.data(), static_cast<slong>(by.size()),
                          a.ring().context());
  return result;
}

Factors factored(const Polynomial& polynomial) {
  const PolynomialRing& ring = polynomial.ring();
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
