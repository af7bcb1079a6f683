// Polynomials with rational coefficients, by FLINT.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <utility>
#include <vector>

#include "core/rational.hpp"

namespace stickslip {

class Polynomial;

// Q[x_0, …, x_{n-1}], lexicographic, x_0 leading. It has to outlive its polynomials.
class PolynomialRing {
 public:
  explicit PolynomialRing(std::size_t generators) : generators_(generators), context_{} {
    fmpq_mpoly_ctx_init(context_, static_cast<slong>(generators), ORD_LEX);
  }
  ~PolynomialRing() { fmpq_mpoly_ctx_clear(context_); }
  PolynomialRing(const PolynomialRing&) = delete;
  PolynomialRing& operator=(const PolynomialRing&) = delete;

  [[nodiscard]] Polynomial generator(std::size_t index) const;  // below generators()
  [[nodiscard]] Polynomial constant(const Rational& value) const;
  [[nodiscard]] std::size_t generators() const { return generators_; }
  [[nodiscard]] const fmpq_mpoly_ctx_struct * context() const { return context_; }

 private:
  std::size_t generators_;
  fmpq_mpoly_ctx_t context_;
};

class Polynomial {
 public:
  explicit Polynomial(const PolynomialRing& ring) : ring_(&ring), raw_{} {  // 0
    fmpq_mpoly_init(raw_, ring.context());
  }
  Polynomial(const Polynomial& other) : Polynomial(*other.ring_) {
    fmpq_mpoly_set(raw_, other.raw_, ring_->context());
  }
  Polynomial(Polynomial&& other) noexcept : Polynomial(*other.ring_) {
    fmpq_mpoly_swap(raw_, other.raw_, ring_->context());
  }
  Polynomial& operator=(Polynomial other) noexcept {
    std::swap(ring_, other.ring_);
    std::swap(raw_[0], other.raw_[0]);
    return *this;
  }
  ~Polynomial() { fmpq_mpoly_clear(raw_, ring_->context()); }

  Polynomial& operator+=(const Polynomial& other) {
    fmpq_mpoly_add(raw_, raw_, other.raw_, ring_->context());
    return *this;
  }
  Polynomial& operator*=(const Polynomial& other) {
    fmpq_mpoly_mul(raw_, raw_, other.raw_, ring_->context());
    return *this;
  }
  friend bool operator==(const Polynomial& a, const Polynomial& b) {
    return fmpq_mpoly_equal(a.raw_, b.raw_, a.ring_->context()) != 0;
  }

  [[nodiscard]] bool is_zero() const { return fmpq_mpoly_is_zero(raw_, ring_->context()) != 0; }
  [[nodiscard]] const PolynomialRing& ring() const { return *ring_; }
  [[nodiscard]] fmpq_mpoly_struct * raw() { return raw_; }
  [[nodiscard]] const fmpq_mpoly_struct * raw() const { return raw_; }

 private:
  const PolynomialRing * ring_;
  fmpq_mpoly_t raw_;
};

// The coefficient of the leading term; 0 of 0.
[[nodiscard]] Rational leading_coefficient(const Polynomial& polynomial);
[[nodiscard]] bool is_constant(const Polynomial& polynomial);
// The highest exponent of a generator, and the coefficient of its `exponent`-th power.
[[nodiscard]] int degree(const Polynomial& polynomial, std::size_t generator);
[[nodiscard]] Polynomial coefficient(const Polynomial& polynomial, std::size_t generator, int exponent);

// All operands are of one ring. Throw std::overflow_error where FLINT gives up, or a quotient leaves a rest.
[[nodiscard]] Polynomial gcd(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial quotient(const Polynomial& a, const Polynomial& b);
// The remainder by a set of polynomials.
[[nodiscard]] Polynomial remainder(const Polynomial& a, const std::vector<Polynomial>& divisors);

}  // namespace stickslip
