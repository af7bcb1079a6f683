// Quotients of polynomials with rational coefficients in generators of a ring, modulo c² + s² = 1 for some
// pairs of them. Not only for the kernel: nothing here makes a Theorem.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/polynomial.hpp"
#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::kernel {

using Integer = mpz_class;

class Ring;

class Quotient {
 public:
  // The denominator is not zero.
  Quotient(const Ring& ring, Polynomial numerator, Polynomial denominator);
  [[nodiscard]] const Polynomial& numerator() const { return numerator_; }
  [[nodiscard]] const Polynomial& denominator() const { return denominator_; }
  [[nodiscard]] bool is_zero() const { return numerator_.is_zero(); }
  // Whether it is a rational number times powers, of any sign, of generators of which that is true.
  [[nodiscard]] bool is_made_of(const std::function<bool(std::size_t generator)>& may_be) const;
  // Throws KernelError for the inverse of zero.
  [[nodiscard]] Quotient inverted() const;

  friend Quotient operator+(const Quotient& a, const Quotient& b);
  friend Quotient operator*(const Quotient& a, const Quotient& b);
  friend bool equal(const Quotient& a, const Quotient& b);
  // The quotient as a sum of coefficient · (monomial/denominator), each in lowest terms and with leading
  // coefficients 1; assumes a ring without circles.
  friend std::vector<std::pair<Rational, Quotient>> terms(const Quotient& quotient);

 private:
  const Ring * ring_;
  Polynomial numerator_, denominator_;
};
// `plain` generators, the 0th of which is π, and `circles` pairs (c, s). Quotients need their ring alive.
class Ring {
 public:
  Ring(std::size_t plain, std::size_t circles);
  [[nodiscard]] Quotient generator(std::size_t index) const;
  [[nodiscard]] Quotient cosine(std::size_t circle) const;
  [[nodiscard]] Quotient sine(std::size_t circle) const;
  [[nodiscard]] Quotient number(const Rational& value) const;
  [[nodiscard]] const PolynomialRing& polynomials() const { return polynomials_; }
  [[nodiscard]] Polynomial constant(const Rational& value) const { return polynomials_.constant(value); }
  [[nodiscard]] Polynomial reduced(Polynomial polynomial) const;  // every s² as 1 - c²
  // Throw KernelError where that would take too long, or exponents no longer fit a machine word.
  [[nodiscard]] Polynomial product(const Polynomial& a, const Polynomial& b) const;
  [[nodiscard]] Polynomial common_divisor(const Polynomial& a, const Polynomial& b) const;
  [[nodiscard]] std::size_t circles() const { return circles_; }

 private:
  void spend(const Polynomial& a, const Polynomial& b) const;

  std::size_t circles_;
  PolynomialRing polynomials_;
  std::vector<Polynomial> relations_;
  mutable long work_ = 0;  // products of terms so far
};

}  // namespace stickslip::proofs::kernel
