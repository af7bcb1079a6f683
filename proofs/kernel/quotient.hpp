// Quotients of polynomials with rational coefficients in generators of a ring, modulo c² + s² = 1 for some
// pairs of them. For normal_form.cpp only.
#pragma once

#include <memory>
#include <vector>

#include "proofs/kernel/term.hpp"
#include "symbolic/algebra/polynomial_ring.hpp"

namespace stickslip::proofs::kernel {

using Integer = mpz_class;

class Ring;

class Quotient {
 public:
  // The denominator is not zero.
  Quotient(const Ring& ring, symbolic::algebra::Polynomial numerator,
           symbolic::algebra::Polynomial denominator);
  [[nodiscard]] bool is_zero() const { return numerator_.is_zero(); }
  // Whether it is a nonzero rational number times a power, of any sign, of the generator.
  [[nodiscard]] bool is_multiple_of_power(std::size_t generator) const;
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
  symbolic::algebra::Polynomial numerator_, denominator_;
};
// `plain` generators, the 0th of which is π, and `circles` pairs (c, s). Quotients need their ring alive.
class Ring {
 public:
  Ring(std::size_t plain, std::size_t circles);
  [[nodiscard]] Quotient generator(std::size_t index) const;
  [[nodiscard]] Quotient cosine(std::size_t circle) const;
  [[nodiscard]] Quotient sine(std::size_t circle) const;
  [[nodiscard]] Quotient number(const Rational& value) const;
  [[nodiscard]] const symbolic::algebra::PolynomialRing& polynomials() const { return polynomials_; }
  [[nodiscard]] symbolic::algebra::Polynomial constant(const Rational& value) const;
  [[nodiscard]] symbolic::algebra::Polynomial reduced(
      symbolic::algebra::Polynomial polynomial) const;  // every s² as 1 - c²
  [[nodiscard]] std::size_t circles() const { return circles_; }

 private:
  std::size_t circles_;
  symbolic::algebra::PolynomialRing polynomials_;
  std::vector<symbolic::algebra::Polynomial> relations_;
};

}  // namespace stickslip::proofs::kernel
