#include "core/polynomial.hpp"

#include <stdexcept>

#include "core/fmpq.hpp"

namespace stickslip {

Polynomial PolynomialRing::generator(std::size_t index) const {
  Polynomial result(*this);
  fmpq_mpoly_gen(result.raw(), static_cast<slong>(index), context_);
  return result;
}

Polynomial PolynomialRing::constant(const Rational& value) const {
  const Fmpq exact(value);
  Polynomial result(*this);
  fmpq_mpoly_set_fmpq(result.raw(), exact.raw(), context_);
  return result;
}

Rational leading_coefficient(const Polynomial& polynomial) {
  Fmpq leading;
  if (!polynomial.is_zero()) {
    fmpq_mpoly_get_term_coeff_fmpq(leading.raw(), polynomial.raw(), 0, polynomial.ring().context());
  }
  return leading.value();
}

bool is_constant(const Polynomial& polynomial) {
  return fmpq_mpoly_is_fmpq(polynomial.raw(), polynomial.ring().context()) != 0;
}

int degree(const Polynomial& polynomial, std::size_t generator) {
  return static_cast<int>(
      fmpq_mpoly_degree_si(polynomial.raw(), static_cast<slong>(generator), polynomial.ring().context()));
}

Polynomial coefficient(const Polynomial& polynomial, std::size_t generator, int exponent) {
  const auto variable = static_cast<slong>(generator);
  const auto power = static_cast<ulong>(exponent);
  Polynomial result(polynomial.ring());
  fmpq_mpoly_get_coeff_vars_ui(result.raw(), polynomial.raw(), &variable, &power, 1,
                               polynomial.ring().context());
  return result;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring());
  if (fmpq_mpoly_gcd(result.raw(), a.raw(), b.raw(), a.ring().context()) == 0) {
    throw std::overflow_error("the greatest common divisor of two polynomials was not found");
  }
  return result;
}

Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring());
  if (b.is_zero() || fmpq_mpoly_divides(result.raw(), a.raw(), b.raw(), a.ring().context()) == 0) {
    throw std::overflow_error("a polynomial is not divisible by another");
  }
  return result;
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

}  // namespace stickslip
