// Terms as quotients of polynomials in what is not rational in them, and back.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/monomials.hpp"
#include "proofs/kernel/quotient.hpp"
#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::tactics {

// A sine or cosine.
[[nodiscard]] inline bool is_wave(const kernel::Term& term) {
  return term.kind() == kernel::Kind::cosine || term.kind() == kernel::Kind::sine;
}

// Without common factors and with whole coefficients; the denominator's leading one is positive.
struct Fraction {
  Polynomial above, below;
};

// Every part of a term that is no sum, product, power or inverse of others is a letter: a generator of the
// ring. What is found with letters is a proposal: the kernel decides.
class Letters {
 public:
  // Those of these terms, in an order that does not depend on where they stand.
  explicit Letters(const std::vector<kernel::Term>& terms);

  // Of a term in these letters. Throws KernelError where that would take too long, ZeroDivisor where it
  // divides by what is zero for all values of the letters.
  [[nodiscard]] Fraction fraction(const kernel::Term& term) const;
  [[nodiscard]] kernel::Term term(const Polynomial& polynomial) const;

  [[nodiscard]] const std::vector<kernel::Term>& terms() const { return terms_; }
  [[nodiscard]] const PolynomialRing& ring() const { return ring_->polynomials(); }

 private:
  [[nodiscard]] kernel::Quotient quotient(const kernel::Term& term) const;

  std::vector<kernel::Term> terms_;
  std::map<kernel::Term, std::size_t> places_;
  std::unique_ptr<kernel::Ring> ring_;
};

// A polynomial in letters as a product.
struct Factored {
  std::vector<Polynomial> factors;  // each once, in an order and a sign of its own
  std::vector<int> exponents;
  Polynomial product;  // of all with their exponents: a rational multiple of what was factored
};
// A sum of more terms than `longest` passes for irreducible.
[[nodiscard]] Factored factored(const Polynomial& polynomial, const Letters& letters,
                                std::size_t longest = 100000);

// a/b without common factors. Throws as Letters::fraction() does.
[[nodiscard]] kernel::Term quotient(const kernel::Term& a, const kernel::Term& b);

// Equations that follow from others as polynomials do.

// Factors m_k with goal = m_1 given_1 + m_2 given_2 + …, all of them numbers, as rational functions of what
// is not rational in them, where cos(x)² + sin(x)² = 1; by a Gröbner basis of the numerators, lexicographic,
// in bounded work. Nothing where it finds none. A proposal: the kernel decides.
[[nodiscard]] std::optional<std::vector<kernel::Term>> multipliers(const kernel::Term& goal,
                                                                   const std::vector<kernel::Term>& given);

}  // namespace stickslip::proofs::tactics
