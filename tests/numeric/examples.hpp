// The data of the paper's examples, and comparison with printed numbers, for the tests.
#pragma once

#include "core/decimal.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "proofs/pascal2012/examples.hpp"

namespace stickslip::examples {

using namespace numeric::motion;
using namespace proofs::pascal2012;

// The data of Figs. 2, 3 and 4.
[[nodiscard]] inline ExactParameters S() {
  return example_named("S").data;
}
[[nodiscard]] inline ExactParameters O() {
  return example_named("O").data;
}
[[nodiscard]] inline ExactParameters P(const char * V = "0") {
  ExactParameters a = example_named("P").data;
  a.V = parse_rational(V);
  return a;
}

// Every member of the ball is closer than `distance` to `value`.
[[nodiscard]] inline bool near(const Ball& ball, const char * value, const char * distance) {
  return (abs(ball - Ball(parse_rational(value))) - Ball(parse_rational(distance))).is_negative();
}

}  // namespace stickslip::examples
