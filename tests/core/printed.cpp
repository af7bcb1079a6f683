#include "core/printed.hpp"

#include <doctest/doctest.h>

using namespace stickslip;

namespace {

Truth compare(const char * printed, const Ball& value) {
  return compare_printed(parse_decimal(printed), value).verdict.truth;
}

}  // namespace

TEST_CASE("a printed value stands for half a unit in its last place, ends included in neither verdict") {
  CHECK(compare("3.142", Ball::pi()) == Truth::proved);
  CHECK(compare("3.141", Ball::pi()) == Truth::refuted);
  CHECK(compare("3.143", Ball::pi()) == Truth::refuted);
  CHECK(compare("-3.142", -Ball::pi()) == Truth::proved);
  const Ball wide = Ball::hull(Ball(parse_rational("3.1414")), Ball(parse_rational("3.1416")));
  CHECK(compare("3.142", wide) == Truth::undecided);
  CHECK(compare("3.1", wide) == Truth::proved);
}

TEST_CASE("the difference counts units in the last place") {
  const PrintedComparison c = compare_printed(parse_decimal("3.1400"), Ball::pi());
  CHECK((abs(c.units - Ball(parse_rational("15.926535"))) - Ball(1e-5)).is_negative());
  CHECK(printed_interval(parse_decimal("3.14")).contains(parse_rational("3.145")));
  CHECK_FALSE(printed_interval(parse_decimal("3.14")).contains(parse_rational("3.1451")));
}
