#include "report/tools/layout.hpp"

#include <doctest/doctest.h>

#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;

TEST_CASE("text is wrapped between words, and a long word within") {
  using Lines = std::vector<std::string>;
  CHECK(wrapped("", 5) == Lines{""});
  CHECK(wrapped("abc", 3) == Lines{"abc"});
  CHECK(wrapped("aa bb cc", 5) == Lines{"aa bb", "cc"});
  CHECK(wrapped("aa bb cc", 6) == Lines{"aa bb", "cc"});
  CHECK(wrapped("abcdefgh", 3) == Lines{"abc", "def", "gh"});
  CHECK(wrapped("ωωωω", 3) == Lines{"ωωω", "ω"});
}

TEST_CASE("columns are as wide as their widest cell, the last one wraps") {
  CHECK(columns_of({{{"a"}, {"x"}, {"one"}}, {{"ωω"}, {"yy"}, {"two"}}}, 80) == "a   x   one\nωω  yy  two\n");
  CHECK(columns_of({{{"a"}, {"aaaaaaaaaa bbbbbbbbbb cccc"}}}, 24) == "a  aaaaaaaaaa bbbbbbbbbb\n   cccc\n");
  CHECK(columns_of({}, 80).empty());
  CHECK(columns_of({{{"a"}, {""}}}, 80) == "a\n");
}

TEST_CASE("colour takes no room") {
  CHECK(columns_of({{{"a", "\x1b[32m"}, {"b"}}, {{"ccc"}, {"d"}}}, 80) == "\x1b[32ma\x1b[0m    b\nccc  d\n");
}

TEST_CASE("code points, also broken ones") {
  CHECK(columns("aω₁") == 3);
  CHECK(columns("x\xcc\x87") == 1);  // x with a combining dot
  CHECK(columns("\xff\xfe") == 2);
  CHECK(code_point("\xe2\x82", 0).length == 1);
}

TEST_CASE("a ball for readers contains the ball") {
  CHECK(readable(Ball(parse_rational("7.7503")), 10).starts_with("7.750300000 ± "));
  CHECK(readable(Ball::from_interval(1, parse_rational("1.5")), 5).starts_with("1.2500 ± 0.25"));
  CHECK(readable(Ball(1) / Ball(0), 5) == "unbounded");
}

TEST_CASE("a value is rounded as the printed one is, unless its ball leaves that open") {
  const auto rounded = [](const char * printed, const char * low, const char * high) {
    return rounded_like(parse_decimal(printed),
                        Ball::from_interval(parse_rational(low), parse_rational(high)));
  };
  CHECK(rounded("7.749", "7.7496", "7.7503") == "7.750");
  CHECK(rounded("-0.411", "-0.4126", "-0.4127") == "-0.413");
  CHECK(rounded("0.1", "0.02", "0.03") == "0.0");
  CHECK(rounded("10", "11.9", "12.1") == "12");
  CHECK_FALSE(rounded("7.749", "7.7494", "7.7496"));
  CHECK_FALSE(rounded_like(parse_decimal("1"), Ball(1) / Ball(0)));
}

TEST_CASE("bounds are rounded away from what they bound") {
  CHECK(below(0.0017051, 3) == "0.0017");
  CHECK(below(0.00170, 3) == "0.0017");
  CHECK(below(0.0017099, 3) == "0.0017");
  CHECK(below(-1.2344, 3) == "-1.24");
  CHECK(above(1.2344, 3) == "1.24");
  CHECK(above(-1.2346, 3) == "-1.23");
  CHECK(above(1, 9) == "1");
  CHECK(above(0, 9) == "0");
}
