// The paper's examples and other data for the tests, exactly.
#pragma once

#include "core/decimal.hpp"
#include "numeric/domain.hpp"
#include "numeric/krawczyk.hpp"

namespace stickslip::examples {

[[nodiscard]] inline ExactParameters parameters(const char* chi, const char* eta, const char* us,
                                                const char* V, const char* omega, const char* p) {
  return {parse_rational(chi), parse_rational(eta),   parse_rational(us),
          parse_rational(V),   parse_rational(omega), parse_rational(p)};
}

// Fig. 2 and Fig. 3.
[[nodiscard]] inline ExactParameters S() {
  return parameters("0.5", "3.8", "0.02", "1", "0.6", "0.05");
}
[[nodiscard]] inline ExactParameters O() {
  return parameters("0.2", "4", "0.05", "1", "0.6289", "0.05");
}

// Every member of the ball is closer than `distance` to `value`.
[[nodiscard]] inline bool near(const Ball& ball, const char* value, const char* distance) {
  return (abs(ball - Ball(parse_rational(value))) - Ball(parse_rational(distance))).is_negative();
}

}  // namespace stickslip::examples
