// Polynomials with rational coefficients, by FLINT: the arithmetic of the normal form.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <vector>

#include "core/decimal.hpp"
#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

class Polynomial;

// Q[x_1, …, x_n] in the given symbols, which must differ; lexicographic, the first symbol leading.
class PolynomialRing {
 public:
  explicit PolynomialRing(const std::vector<GiNaC::ex>& symbols);
  ~PolynomialRing();
  PolynomialRing(const PolynomialRing&) = delete;
  PolynomialRing& operator=(const PolynomialRing&) = delete;

  // Throws InternalError if the symbol is not one of the ring's.
  [[nodiscard]] Polynomial generator(const GiNaC::ex& symbol) const;
  [[nodiscard]] Polynomial constant(const GiNaC::numeric& rational) const;

  // The polynomial as a sum of monomials in the ring's symbols.
  [[nodiscard]] GiNaC::ex expression(const Polynomial& polynomial) const;

  [[nodiscard]] const std::vector<GiNaC::ex>& symbols() const { return symbols_; }
  [[nodiscard]] const fmpq_mpoly_ctx_struct * context() const { return context_; }

 private:
  std::vector<GiNaC::ex> symbols_;
  fmpq_mpoly_ctx_t context_;
};

// An element of a ring, which has to outlive it.
class Polynomial {
 public:
  explicit Polynomial(const PolynomialRing& ring);  // 0
  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(Polynomial other) noexcept;
  ~Polynomial();

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator*=(const Polynomial& other);

  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] const PolynomialRing& ring() const { return *ring_; }
  [[nodiscard]] fmpq_mpoly_struct * raw() { return raw_; }
  [[nodiscard]] const fmpq_mpoly_struct * raw() const { return raw_; }

 private:
  const PolynomialRing * ring_;
  fmpq_mpoly_t raw_;
};

// All operands are of one ring.
[[nodiscard]] bool operator==(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial pow(const Polynomial& base, unsigned long exponent);
[[nodiscard]] Polynomial gcd(const Polynomial& a, const Polynomial& b);
[[nodiscard]] bool divides(const Polynomial& divisor, const Polynomial& multiple);
// a/b. Throws InternalError if b does not divide a.
[[nodiscard]] Polynomial quotient(const Polynomial& a, const Polynomial& b);
// The remainder by a set of polynomials.
[[nodiscard]] Polynomial remainder(const Polynomial& a, const std::vector<Polynomial>& divisors);

// An irreducible polynomial with integer coefficients, and how often it stands in a product.
struct Factor {
  Polynomial base;
  unsigned long exponent = 1;
};

// A polynomial other than 0 as constant * product of powers.
struct Factors {
  Rational constant;
  std::vector<Factor> factors;
};
[[nodiscard]] Factors factored(const Polynomial& polynomial);

}  // namespace stickslip::symbolic::algebra
