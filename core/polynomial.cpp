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
