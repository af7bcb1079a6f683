#include "report/tools/layout.hpp"

#include <doctest/doctest.h>

#include "report/tools/numbers.hpp"
#include "report/tools/unicode.hpp"

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
  CHECK(readable({"7.7503", "0"}, 10).starts_with("7.750300000 ± "));
  CHECK(readable({"1.25", "0.25"}, 5).starts_with("1.2500 ± 0.25"));
  CHECK(readable({"nan", "inf"}, 5) == "unbounded");
}
