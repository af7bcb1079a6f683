#include "core/decimal.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"

using namespace stickslip;

TEST_CASE("decimals are read exactly") {
  CHECK(parse_decimal("0.1607").value == Rational(1607, 10000));
  CHECK(parse_decimal("0.1607").unit == Rational(1, 10000));
  CHECK(parse_decimal("-0.50").value == Rational(-1, 2));
  CHECK(parse_decimal("-0.50").unit == Rational(1, 100));
  CHECK(parse_decimal("\u22120.4117").value == Rational(-4117, 10000));
  CHECK(parse_decimal("4").unit == 1);
  CHECK(parse_decimal("2.5e-3").value == Rational(1, 400));
  CHECK(parse_decimal("2.5E+3").unit == 100);
  CHECK(parse_decimal(".5").value == Rational(1, 2));
  CHECK(parse_decimal("7.749").lower() == Rational(15497, 2000));
  CHECK(parse_decimal("7.749").upper() == Rational(15499, 2000));
}

TEST_CASE("fractions are read exactly") {
  CHECK(parse_rational("2/6") == Rational(1, 3));
  CHECK(parse_rational("-1/3") == Rational(-1, 3));
  CHECK(parse_rational("0.125") == Rational(1, 8));
}

TEST_CASE("anything else is refused, and the text is named") {
  for (const char * text : {"", "-", ".", "1,5", "0x10", "nan", "inf", "1e", "1e99999999", "1.2.3", "5 ",
                            " 5", "1/0", "1/", "/2", "1/-2", "--1", "e5", "1/2/3"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)parse_rational(text), UsageError);
    CHECK_THROWS_WITH((void)parse_rational(text), doctest::Contains(text));
  }
}

TEST_CASE("rationals are written exactly and shortly") {
  CHECK(to_string(Rational(1, 2)) == "0.5");
  CHECK(to_string(Rational(-1, 20)) == "-0.05");
  CHECK(to_string(Rational(1, 3)) == "1/3");
  CHECK(to_string(Rational(1250)) == "1250");
  CHECK(to_string(Rational(0)) == "0");
  CHECK(to_string(parse_rational("1e-50")) == "1/1" + std::string(50, '0'));
  for (const char * text : {"0.1607", "-12.5", "3", "0.0001"}) {
    CHECK(to_string(parse_rational(text)) == text);
  }
}
