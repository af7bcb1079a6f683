#include "symbolic/algebra/symbols.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::algebra;
using GiNaC::ex;

TEST_CASE("expressions in balls contain their exact values") {
  const ex t = symbol("t");
  const BallValues at_third{{t, Ball(Rational(1, 3))}};
  CHECK(evaluate(3 * t - GiNaC::pow(t, -2) + ex(7) / 5, at_third).contains(Rational(-33, 5)));
  CHECK(evaluate(GiNaC::sqrt(27 * t), at_third).contains(Rational(3)));
  CHECK(evaluate(GiNaC::pow(12 * t, ex(-3) / 2), at_third).contains(Rational(1, 8)));
  CHECK(evaluate(GiNaC::tan(t) - GiNaC::sin(t) / GiNaC::cos(t), at_third).contains_zero());
  CHECK(evaluate(GiNaC::cos(GiNaC::Pi * t), at_third).contains(Rational(1, 2)));
  CHECK_FALSE(evaluate(1 / (3 * t - 1), at_third).is_finite());
}

TEST_CASE("what has no value is an internal error") {
  CHECK_THROWS_AS((void)evaluate(symbol("s"), {}), InternalError);
  CHECK_THROWS_AS((void)evaluate(GiNaC::exp(symbol("t")), {{symbol("t"), Ball(1)}}), InternalError);
}

TEST_CASE("rationals pass exactly") {
  const Rational value(mpz_class("-123456789012345678901234567891"), 7);
  CHECK(to_rational(GiNaC::numeric("-123456789012345678901234567891") / GiNaC::numeric(7)) == value);
}
