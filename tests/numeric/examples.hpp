// The data of the paper's examples, and comparison with printed numbers, for the tests.
#pragma once

#include <optional>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/orbits.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

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

// All orbits of the family, with phi or ur where they are given.
[[nodiscard]] inline numeric::OrbitList listed(const numeric::Family& family, const ExactParameters& a,
                                               int digits, const std::optional<Rational>& phi = {},
                                               const std::optional<Rational>& ur = {}) {
  numeric::OrbitQuestion q{&family, {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}}, {}, {}, digits};
  if (phi) {
    q.phi = Range{*phi};
  }
  if (ur) {
    q.ur = Range{*ur};
  }
  return numeric::list_orbits(q);
}

// Every member of the ball is closer than `distance` to `value`.
[[nodiscard]] inline bool near(const Ball& ball, const char * value, const char * distance) {
  return (abs(ball - Ball(parse_rational(value))) - Ball(parse_rational(distance))).is_negative();
}

}  // namespace stickslip::examples
