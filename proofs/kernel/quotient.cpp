#include "proofs/kernel/quotient.hpp"

#include <stdexcept>

namespace stickslip::proofs::kernel {
namespace {

constexpr long most_work = 100000000;  // products of terms in one normal form: some seconds
constexpr flint_bitcnt_t most_bits = 1000000;

// The leading coefficient, by which the polynomial is divided; it is not zero.
Rational take_leading(Polynomial& polynomial) {
  const Rational leading = leading_coefficient(polynomial);
  polynomial *= polynomial.ring().constant(1 / leading);
  return leading;
}

}  // namespace

// Every s before its c, and both before everything else: then the relations are a Gröbner basis.
Ring::Ring(std::size_t plain, std::size_t circles) : circles_(circles), polynomials_(2 * circles + plain) {
  for (std::size_t i = 0; i < circles; ++i) {
    const Polynomial s = polynomials_.generator(2 * i), c = polynomials_.generator(2 * i + 1);
    Polynomial relation = product(s, s);
    relation += product(c, c);
    relation += constant(-1);
    relations_.push_back(relation);
  }
}

void Ring::spend(const Polynomial& a, const Polynomial& b) const {
  const auto length = [&](const Polynomial& p) { return fmpq_mpoly_length(p.raw(), polynomials_.context()); };
  work_ += length(a) * length(b);
  if (length(a) > most_work / 100 || length(b) > most_work / 100 || work_ > most_work) {
    throw KernelError("a normal form takes more than 10^8 products of terms");
  }
}

Polynomial Ring::product(const Polynomial& a, const Polynomial& b) const {
  const auto * context = polynomials_.context();
  if (fmpq_mpoly_is_one(a.raw(), context) != 0 || fmpq_mpoly_is_one(b.raw(), context) != 0) {
    return fmpq_mpoly_is_one(a.raw(), context) != 0 ? b : a;
  }
  spend(a, b);
  Polynomial result(polynomials_);
  fmpq_mpoly_mul(result.raw(), a.raw(), b.raw(), context);
  const fmpq_mpoly_struct& made = *result.raw();
  if (made.zpoly->bits > FLINT_BITS || fmpz_bits(fmpq_numref(made.content)) > most_bits ||
      fmpz_bits(fmpq_denref(made.content)) > most_bits ||
      std::abs(fmpz_mpoly_max_bits(made.zpoly)) > static_cast<slong>(most_bits)) {
    throw KernelError("a number in a normal form is too large");
  }
  return result;
}

Polynomial Ring::common_divisor(const Polynomial& a, const Polynomial& b) const {
  spend(a, b);
  try {
    return gcd(a, b);
  } catch (const std::overflow_error& gave_up) {
    throw KernelError(gave_up.what());
  }
}

Quotient Ring::generator(std::size_t index) const {
  return {*this, polynomials_.generator(2 * circles_ + index), constant(1)};
}
Quotient Ring::cosine(std::size_t circle) const {
  return {*this, polynomials_.generator(2 * circle + 1), constant(1)};
}
Quotient Ring::sine(std::size_t circle) const {
  return {*this, polynomials_.generator(2 * circle), constant(1)};
}
Quotient Ring::number(const Rational& value) const {
  return {*this, constant(value), constant(1)};
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

bool Quotient::is_made_of(const std::function<bool(std::size_t)>& may_be) const {
  const auto is_power = [&](const Polynomial& p) {
    const auto * context = p.ring().context();
    if (fmpq_mpoly_length(p.raw(), context) != 1) {
      return false;
    }
    const std::size_t circles = 2 * ring_->circles();
    for (std::size_t k = 0; k < p.ring().generators(); ++k) {
      if ((k < circles || !may_be(k - circles)) &&
          fmpq_mpoly_get_term_var_exp_ui(p.raw(), 0, static_cast<slong>(k), context) != 0) {
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
  const Ring& ring = *a.ring_;
  const Polynomial common = ring.common_divisor(a.denominator_, b.denominator_);
  const Polynomial missing = quotient(b.denominator_, common);
  Polynomial total = ring.product(a.numerator_, missing);
  total += ring.product(quotient(a.denominator_, common), b.numerator_);
  return {ring, std::move(total), ring.product(a.denominator_, missing)};
}

Quotient operator*(const Quotient& a, const Quotient& b) {
  if (a.is_zero() || b.is_zero()) {
    return a.is_zero() ? a : b;
  }
  const Ring& ring = *a.ring_;
  return {ring, ring.product(a.numerator_, b.numerator_), ring.product(a.denominator_, b.denominator_)};
}

bool equal(const Quotient& a, const Quotient& b) {
  const Ring& ring = *a.ring_;
  return ring.product(a.numerator_, b.denominator_) == ring.product(b.numerator_, a.denominator_);
}

std::vector<std::pair<Rational, Quotient>> terms(const Quotient& whole) {
  std::vector<std::pair<Rational, Quotient>> result;
  const Ring& ring = *whole.ring_;
  const auto * context = ring.polynomials().context();
  const Polynomial shared = ring.common_divisor(whole.numerator_, whole.denominator_);
  const Polynomial numerator = quotient(whole.numerator_, shared);
  const Polynomial denominator = quotient(whole.denominator_, shared);
  for (slong i = 0; i < fmpq_mpoly_length(numerator.raw(), context); ++i) {
    Polynomial term(ring.polynomials());
    fmpq_mpoly_get_term(term.raw(), numerator.raw(), i, context);
    const Polynomial common = ring.common_divisor(term, denominator);
    Polynomial above = quotient(term, common);
    Polynomial below = quotient(denominator, common);
    const Rational coefficient = take_leading(above) / take_leading(below);
    result.emplace_back(coefficient, Quotient{ring, std::move(above), std::move(below)});
  }
  return result;
}

}  // namespace stickslip::proofs::kernel
