#include "core/ball.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"

using namespace stickslip;

TEST_CASE("operations contain the exact result") {
  const Ball third(Rational(1, 3));
  CHECK(third.contains(Rational(1, 3)));
  CHECK((third * Ball(3)).contains(Rational(1)));
  CHECK((third - Ball(Rational(1, 7))).contains(Rational(4, 21)));
  CHECK((third / Ball(Rational(1, 7))).contains(Rational(7, 3)));
  CHECK((-third).contains(Rational(-1, 3)));
  CHECK(sqrt(Ball(Rational(4, 9))).contains(Rational(2, 3)));
  CHECK(abs(Ball(-2)).contains(Rational(2)));
}

TEST_CASE("the working precision is what it says, and ends with its scope") {
  const long before = WorkingPrecision::bits();
  {
    const WorkingPrecision precision(1000);
    const Ball third(Rational(1, 3));
    CHECK((third.radius() - Ball(parse_rational("1e-290"))).is_negative());
    CHECK((third.radius() - Ball(parse_rational("1e-320"))).is_positive());
  }
  CHECK(WorkingPrecision::bits() == before);
}

TEST_CASE("what is not defined decides nothing") {
  const Ball nothing = Ball(1) / Ball::from_interval(Rational(-1), Rational(1));
  CHECK_FALSE(nothing.is_finite());
  CHECK_FALSE(nothing.is_positive());
  CHECK(nothing.overlaps(Ball(17)));
  CHECK(nothing.contains_zero());
  CHECK(to_text(nothing).rad == "inf");
  CHECK_FALSE(sqrt(Ball(-1)).is_finite());
}

TEST_CASE("intervals, hulls, ends") {
  const Ball box = Ball::from_interval(Rational(1, 10), Rational(1, 5));
  CHECK(box.contains(Rational(1, 10)));
  CHECK(box.contains(Rational(1, 5)));
  CHECK(Ball(Rational(3, 20)).is_interior_to(box));
  CHECK_FALSE(box.is_interior_to(box));
  CHECK_FALSE((box.lower() - Ball(Rational(1, 10))).is_positive());
  CHECK((Ball(Rational(1, 10)) - box.lower() - Ball(1e-8)).is_negative());
  CHECK(Ball::hull(Ball(1), Ball(2)).contains(Rational(3, 2)));
}

TEST_CASE("a ball's text covers the ball") {
  const WorkingPrecision precision(256);
  const Ball ball =
      sin(Ball(Rational(1, 3))) + Ball::from_interval(Rational(-1, 1000000), Rational(1, 1000000));
  for (const int digits : {1, 3, 10, 40, 70}) {
    CAPTURE(digits);
    const BallText text = to_text(ball, digits);
    const Rational mid = parse_decimal(text.mid).value;
    const Rational rad = parse_decimal(text.rad).value;
    CHECK(Ball::from_interval(mid - rad, mid + rad).contains(ball));
    CHECK(rad < parse_rational("1.1e-6") + parse_rational(digits == 1   ? "0.1"
                                                          : digits == 3 ? "0.001"
                                                                        : "1e-10"));
  }
  // Beyond the exponents that are read back.
  const auto value = [](const std::string& text) {
    const std::size_t at = text.find('e');
    const long exponent = std::stol(text.substr(at + 1));
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    const Rational mantissa = parse_decimal(text.substr(0, at)).value;
    return Rational(exponent < 0 ? Rational(mantissa / power) : Rational(mantissa * power));
  };
  for (const long exponent : {30000L, -30000L}) {
    const Ball far = exp(Ball(exponent));
    const BallText text = to_text(far, 10);
    CAPTURE(text.mid);
    const Rational mid = value(text.mid), rad = value(text.rad);
    CHECK(Ball::from_interval(mid - rad, mid + rad).contains(far));
    CHECK(rad < mid / 10000000);
  }
  CHECK(to_text(Ball(0)).rad == "0");
  CHECK(to_text(Ball(0)).mid == "0");
}
