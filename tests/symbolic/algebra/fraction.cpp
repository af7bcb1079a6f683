#include <doctest/doctest.h>

#include "symbolic/algebra/normal_form.hpp"
#include "tests/symbolic/algebra/letters.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::algebra;
using namespace stickslip::symbolic::algebra::letters;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::pow;
using GiNaC::sin;

namespace {

// The expression in lowest terms, as a quotient again.
ex lowest_terms(const ex& expression) {
  const TrigField field({expression});
  const Fraction fraction = field.fraction(expression);
  return field.expression(fraction.numerator) / field.expression(fraction.denominator);
}

}  // namespace

TEST_CASE("fractions come in lowest terms") {
  CHECK(lowest_terms((a * a - b * b) / (a - b)).is_equal(a + b));
  CHECK(lowest_terms(1 / a - 1 / b + (a - b) / (a * b)).is_zero());
  CHECK(lowest_terms(a / (a + b) + b / (a + b)).is_equal(1));
  CHECK(lowest_terms(pow(a / 3, -2) * a).is_equal(9 / a));
  // What GiNaC's own normal form says.
  const ex messy = (a + 1 / b) / (b - 1 / a) - pow(a - b, 3) / (a * a - b * b) + ex(2) / 7;
  CHECK((lowest_terms(messy) - messy).normal().is_zero());
  CHECK_FALSE(lowest_terms(messy).is_zero());
}

TEST_CASE("numbers of any size are exact") {
  const ex big =
      GiNaC::numeric("123456789012345678901234567890") / GiNaC::numeric("98765432109876543210987654321");
  CHECK(lowest_terms(big * a).is_equal(big * a));
  CHECK(lowest_terms(big - big * (1 - a)).is_equal(big * a));
}

TEST_CASE("on the circle, sin^2 = 1 - cos^2") {
  CHECK(lowest_terms(pow(sin(a), 4)).expand().is_equal(1 - 2 * pow(cos(a), 2) + pow(cos(a), 4)));
  CHECK(lowest_terms(pow(sin(a), 2) + pow(cos(a), 2) - 1).is_zero());
  CHECK(lowest_terms(sin(a + b) * cos(a - b) - (sin(2 * a) + sin(2 * b)) / 2).is_zero());
  CHECK_FALSE(lowest_terms(sin(a + b) * cos(a - b) - (sin(2 * a) - sin(2 * b)) / 2).is_zero());
}

TEST_CASE("a denominator that is zero on the circle only is noticed") {
  CHECK_THROWS_AS(lowest_terms(1 / (pow(sin(a), 2) + pow(cos(a), 2) - 1)), OutsideField);
  CHECK_THROWS_AS(lowest_terms(b / (sin(a + b) - sin(a) * cos(b) - cos(a) * sin(b))), OutsideField);
}

TEST_CASE("a polynomial is its constant times its factors") {
  const TrigField field({a, b});
  const Factors factors = factored(field.fraction((a * a - b * b) * (a - b) * -ex(3) / 2).numerator);
  ex product = GiNaC::numeric(factors.constant.get_str().c_str());
  for (const Factor& factor : factors.factors) {
    product *= pow(field.expression(factor.base), GiNaC::numeric(factor.exponent));
  }
  CHECK(factors.factors.size() == 2);
  CHECK((product - (a * a - b * b) * (a - b) * -ex(3) / 2).expand().is_zero());
}
