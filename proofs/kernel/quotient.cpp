#include "proofs/kernel/quotient.hpp"

#include <flint/fmpq_mpoly.h>

#include <algorithm>

#include "core/fmpq.hpp"

namespace stickslip::proofs::kernel {
namespace {

using symbolic::algebra::Polynomial;
using symbolic::algebra::PolynomialRing;

constexpr slong largest_product = 10000000;

// Labels; which of them is which, only the index says.
std::vector<GiNaC::ex> labels(std::size_t count) {
  std::vector<GiNaC::ex> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.emplace_back(GiNaC::symbol());
  }
  return result;
}

Polynomial generator_of(const PolynomialRing& ring, std::size_t index) {
  Polynomial result(ring);
  fmpq_mpoly_gen(result.raw(), static_cast<slong>(index), ring.context());
  return result;
}

// Refuses what would fill the memory.
Polynomial times(const Polynomial& a, const Polynomial& b) {
  const auto * context = a.ring().context();
  if (fmpq_mpoly_is_one(a.raw(), context) != 0 || fmpq_mpoly_is_one(b.raw(), context) != 0) {
    return fmpq_mpoly_is_one(a.raw(), context) != 0 ? b : a;
  }
  if (fmpq_mpoly_length(a.raw(), context) * fmpq_mpoly_length(b.raw(), context) > largest_product) {
    throw KernelError("a normal form has too many terms");
  }
  Polynomial product(a.ring());
  fmpq_mpoly_mul(product.raw(), a.raw(), b.raw(), context);
  return product;
}

// The leading coefficient, by which the polynomial is divided; it is not zero.
Rational take_leading(Polynomial& polynomial) {
  Fmpq leading;
  fmpq_mpoly_get_term_coeff_fmpq(leading.raw(), polynomial.raw(), 0, polynomial.ring().context());
  fmpq_mpoly_scalar_div_fmpq(polynomial.raw(), polynomial.raw(), leading.raw(), polynomial.ring().context());
  return leading.value();
}

}  // namespace

// Every s before its c, and both before everything else: then the relations are a Gröbner basis.
Ring::Ring(std::size_t plain, std::size_t circles)
    : circles_(circles), polynomials_(labels(2 * circles + plain)) {
  for (std::size_t i = 0; i < circles; ++i) {
    Polynomial relation = pow(generator_of(polynomials_, 2 * i), 2);
    relation += pow(generator_of(polynomials_, 2 * i + 1), 2);
    relation += constant(-1);
    relations_.push_back(relation);
  }
}

Quotient Ring::generator(std::size_t index) const {
  return {*this, generator_of(polynomials_, 2 * circles_ + index), constant(1)};
}
Quotient Ring::cosine(std::size_t circle) const {
  return {*this, generator_of(polynomials_, 2 * circle + 1), constant(1)};
}
Quotient Ring::sine(std::size_t circle) const {
  return {*this, generator_of(polynomials_, 2 * circle), constant(1)};
}
Quotient Ring::number(const Rational& value) const {
  return {*this, constant(value), constant(1)};
}

Polynomial Ring::constant(const Rational& value) const {
  const Fmpq exact(value);
  Polynomial result(polynomials_);
  fmpq_mpoly_set_fmpq(result.raw(), exact.raw(), polynomials_.context());
  return result;
}

Polynomial Ring::reduced(Polynomial polynomial) const {
  for (std::size_t i = 0; i < circles_; ++i) {
    if (fmpq_mpoly_degree_si(polynomial.raw(), static_cast<slong>(2 * i), polynomials_.context()) > 1) {
      return remainder(polynomial, relations_);
    }
  }
  return polynomial;  // no s² in it
}

Quotient::Quotient(const Ring& ring, Polynomial numerator, Polynomial denominator)
    : ring_(&ring), numerator_(ring.reduced(std::move(numerator))), denominator_(std::move(denominator)) {
  if (numerator_.is_zero()) {
    denominator_ = ring.constant(1);
  }
}

bool Quotient::is_multiple_of_power(std::size_t generator) const {
  const auto is_power = [&](const Polynomial& p) {
    const auto * context = p.ring().context();
    if (fmpq_mpoly_length(p.raw(), context) != 1) {
      return false;
    }
    const std::size_t wanted = 2 * ring_->circles() + generator;
    for (std::size_t k = 0; k < p.ring().symbols().size(); ++k) {
      if (k != wanted && fmpq_mpoly_get_term_var_exp_ui(p.raw(), 0, static_cast<slong>(k), context) != 0) {
        return false;
      }
    }
    return true;
  };
  return is_power(numerator_) && is_power(denominator_);
}

Quotient Quotient::inverted() const {
  if (is_zero()) {
    throw ZeroDivisor("a term divides by what is zero for all values of its variables");
  }
  return {*ring_, denominator_, numerator_};
}

// Over the least common multiple of the denominators.
Quotient operator+(const Quotient& a, const Quotient& b) {
  if (a.is_zero() || b.is_zero()) {
    return a.is_zero() ? b : a;
  }
  if (a.denominator_ == b.denominator_) {
    Polynomial total = a.numerator_;
    total += b.numerator_;
    return {*a.ring_, std::move(total), a.denominator_};
  }
  const Polynomial common = gcd(a.denominator_, b.denominator_);
  const Polynomial missing = quotient(b.denominator_, common);
  Polynomial total = times(a.numerator_, missing);
  total += times(quotient(a.denominator_, common), b.numerator_);
  return {*a.ring_, std::move(total), times(a.denominator_, missing)};
}

Quotient operator*(const Quotient& a, const Quotient& b) {
  if (a.is_zero() || b.is_zero()) {
    return a.is_zero() ? a : b;
  }
  return {*a.ring_, times(a.numerator_, b.numerator_), times(a.denominator_, b.denominator_)};
}

bool equal(const Quotient& a, const Quotient& b) {
  return times(a.numerator_, b.denominator_) == times(b.numerator_, a.denominator_);
}

std::vector<std::pair<Rational, Quotient>> terms(const Quotient& whole) {
  std::vector<std::pair<Rational, Quotient>> result;
  const auto * context = whole.ring_->polynomials().context();
  const Polynomial shared = gcd(whole.numerator_, whole.denominator_);
  const Polynomial numerator = quotient(whole.numerator_, shared);
  const Polynomial denominator = quotient(whole.denominator_, shared);
  for (slong i = 0; i < fmpq_mpoly_length(numerator.raw(), context); ++i) {
    Polynomial term(whole.ring_->polynomials());
    fmpq_mpoly_get_term(term.raw(), numerator.raw(), i, context);
    const Polynomial common = gcd(term, denominator);
    Polynomial above = quotient(term, common);
    Polynomial below = quotient(denominator, common);
    const Rational coefficient = take_leading(above) / take_leading(below);
    result.emplace_back(coefficient, Quotient{*whole.ring_, std::move(above), std::move(below)});
  }
  return result;
}

}  // namespace stickslip::proofs::kernel
