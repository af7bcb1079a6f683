#include "symbolic/algebra/fraction.hpp"

#include <utility>

#include "core/error.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/normal_form.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

class ToFraction {
 public:
  ToFraction(const PolynomialRing& ring, const std::vector<Polynomial>& relations)
      : ring_(ring), relations_(relations) {}

  [[nodiscard]] Fraction operator()(const ex& e) const {
    if (is_a<GiNaC::numeric>(e)) {
      return {ring_.constant(ex_to<GiNaC::numeric>(e)), one()};
    }
    if (is_a<GiNaC::symbol>(e)) {
      return {ring_.generator(e), one()};
    }
    if (is_a<GiNaC::add>(e)) {
      Fraction sum{Polynomial(ring_), one()};
      for (const ex& term : e) {
        add(sum, (*this)(term));
      }
      return reduced(std::move(sum));
    }
    if (is_a<GiNaC::mul>(e)) {
      Fraction product{one(), one()};
      for (const ex& factor : e) {
        const Fraction next = (*this)(factor);
        product.numerator *= next.numerator;
        product.denominator *= next.denominator;
      }
      return reduced(std::move(product));
    }
    if (is_a<GiNaC::power>(e)) {
      return reduced(power((*this)(e.op(0)), ex_to<GiNaC::numeric>(e.op(1)).to_long()));
    }
    throw InternalError("the expression " + plain(e) + " is not rational in symbols");
  }

 private:
  [[nodiscard]] Polynomial one() const { return ring_.constant(1); }

  [[nodiscard]] Fraction reduced(Fraction fraction) const {
    fraction.numerator = remainder(fraction.numerator, relations_);
    return fraction;
  }

  // Over the least common multiple of the denominators.
  static void add(Fraction& sum, const Fraction& term) {
    if (sum.denominator == term.denominator) {
      sum.numerator += term.numerator;
      return;
    }
    const Polynomial common = gcd(sum.denominator, term.denominator);
    const Polynomial missing = quotient(term.denominator, common);
    sum.numerator *= missing;
    Polynomial other = quotient(sum.denominator, common);
    other *= term.numerator;
    sum.numerator += other;
    sum.denominator *= missing;
  }

  [[nodiscard]] static Fraction power(Fraction base, long exponent) {
    if (exponent < 0) {
      if (base.numerator.is_zero()) {
        throw OutsideField(divides_by_zero);
      }
      std::swap(base.numerator, base.denominator);
      exponent = -exponent;
    }
    const auto times = static_cast<unsigned long>(exponent);
    return {pow(base.numerator, times), pow(base.denominator, times)};
  }

  const PolynomialRing& ring_;
  const std::vector<Polynomial>& relations_;
};

}  // namespace

Fraction over_one_denominator(const ex& expression, const PolynomialRing& ring,
                              const std::vector<Polynomial>& relations) {
  Fraction result = ToFraction(ring, relations)(expression);
  const Polynomial common = gcd(result.numerator, result.denominator);
  return {quotient(result.numerator, common), quotient(result.denominator, common)};
}

}  // namespace stickslip::symbolic::algebra
