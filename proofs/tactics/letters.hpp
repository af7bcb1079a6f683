// Terms as rational functions of what is not rational in them, and back.
#pragma once

#include <ginac/ginac.h>

#include <utility>
#include <vector>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::tactics {

// Every part of a term that is no sum, product, power or inverse of others is a letter. What GiNaC does with
// letters is a proposal: the kernel decides.
class Letters {
 public:
  [[nodiscard]] GiNaC::ex expression(const kernel::Term& term);

  struct Monomial {
    std::vector<int> degrees;  // of the letters
    Rational coefficient;
  };
  // Sorted, the highest first.
  [[nodiscard]] std::vector<Monomial> monomials(const GiNaC::ex& polynomial) const;
  [[nodiscard]] kernel::Term term(const GiNaC::ex& polynomial) const;

  // Numerator and denominator without common factors. The denominator's highest monomial is positive: GiNaC
  // alone has its signs from addresses in memory.
  [[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> fraction(const GiNaC::ex& expression) const;

  // Puts the letters into an order that does not depend on where they stood.
  void sort();
  [[nodiscard]] const std::vector<kernel::Term>& terms() const { return terms_; }
  [[nodiscard]] const std::vector<GiNaC::symbol>& symbols() const { return symbols_; }

 private:
  [[nodiscard]] GiNaC::ex letter(const kernel::Term& term);

  std::vector<kernel::Term> terms_;
  std::vector<GiNaC::symbol> symbols_;
};

// A polynomial in letters as a product.
struct Factored {
  std::vector<GiNaC::ex> factors;  // each once, in an order and a sign of its own
  GiNaC::ex product = 1;           // of all with their exponents, as monomials
  std::vector<int> exponents;
};
// A sum of more terms than `longest` passes for irreducible.
[[nodiscard]] Factored factored(const GiNaC::ex& numerator, const Letters& letters,
                                std::size_t longest = 100000);

// a/b without common factors.
[[nodiscard]] kernel::Term quotient(const kernel::Term& a, const kernel::Term& b);

}  // namespace stickslip::proofs::tactics
