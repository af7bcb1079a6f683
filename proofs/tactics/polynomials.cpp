#include "proofs/tactics/polynomials.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <memory>
#include <stdexcept>

#include "core/fmpq.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::proofs::tactics {

using Monomial = Letters::Monomial;

std::vector<Monomial> monomials(const Polynomial& polynomial) {
  const PolynomialRing& ring = polynomial.ring();
  std::vector<Monomial> result;
  std::vector<ulong> exponents(ring.generators());
  for (slong k = 0; k < fmpq_mpoly_length(polynomial.raw(), ring.context()); ++k) {
    Fmpq coefficient;
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), polynomial.raw(), k, ring.context());
    fmpq_mpoly_get_term_exp_ui(exponents.data(), polynomial.raw(), k, ring.context());
    result.push_back({{exponents.begin(), exponents.end()}, coefficient.value()});
  }
  return result;
}

Polynomial polynomial(const PolynomialRing& ring, const std::vector<Monomial>& monomials) {
  Polynomial sum(ring);
  for (const Monomial& monomial : monomials) {
    Polynomial product = ring.constant(monomial.coefficient);
    for (std::size_t i = 0; i < monomial.degrees.size(); ++i) {
      for (int k = 0; k < monomial.degrees[i]; ++k) {
        product *= ring.generator(i);
      }
    }
    sum += product;
  }
  return sum;
}

GiNaC::ex expression(const std::vector<Monomial>& monomials, const Letters& letters) {
  GiNaC::ex sum = 0;
  for (const Monomial& monomial : monomials) {
    GiNaC::ex product = symbolic::algebra::to_ex(monomial.coefficient);
    for (std::size_t i = 0; i < monomial.degrees.size(); ++i) {
      product *= pow(letters.symbols()[i], monomial.degrees[i]);
    }
    sum += product;
  }
  return sum;
}

namespace {

class Factors {
 public:
  explicit Factors(const PolynomialRing& ring) : ring_(ring), raw_{} {
    fmpq_mpoly_factor_init(raw_, ring.context());
  }
  ~Factors() { fmpq_mpoly_factor_clear(raw_, ring_.context()); }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
  [[nodiscard]] fmpq_mpoly_factor_struct * raw() { return raw_; }

 private:
  const PolynomialRing& ring_;
  fmpq_mpoly_factor_t raw_;
};

// Times what makes its coefficients whole and without a common divisor.
Polynomial primitive(Polynomial polynomial) {
  mpz_class above = 0, below = 1;
  for (const Monomial& one : monomials(polynomial)) {
    above = gcd(above, one.coefficient.get_num());
    below = lcm(below, one.coefficient.get_den());
  }
  Rational content(above, below);
  content.canonicalize();
  polynomial *= polynomial.ring().constant(1 / content);
  return polynomial;
}

}  // namespace

std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& polynomial) {
  const PolynomialRing& ring = polynomial.ring();
  Factors found(ring);
  if (fmpq_mpoly_factor(found.raw(), polynomial.raw(), ring.context()) == 0) {
    throw std::overflow_error("the factors of a polynomial were not found");
  }
  std::vector<std::pair<Polynomial, int>> result;
  for (slong k = 0; k < fmpq_mpoly_factor_length(found.raw(), ring.context()); ++k) {
    Polynomial base(ring);
    fmpq_mpoly_factor_get_base(base.raw(), found.raw(), k, ring.context());
    result.emplace_back(primitive(std::move(base)),
                        static_cast<int>(fmpq_mpoly_factor_get_exp_si(found.raw(), k, ring.context())));
  }
  return result;
}

}  // namespace stickslip::proofs::tactics
