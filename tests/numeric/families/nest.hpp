// Balls within balls around a random rational number, and the question whether a routine over them keeps its
// promise at that number.
#pragma once

#include <array>
#include <vector>

#include "tests/numeric/families/random_data.hpp"

namespace stickslip::examples {

// A rational number, often small, large or a half.
inline Rational corner(RandomData& random) {
  const Rational x = random.between(-3, 3);
  switch (static_cast<int>(random.between(0, 5).get_d())) {
    case 0:
      return x / 1000000;
    case 1:
      return x * 1000;
    case 2:
      return x > 0 ? Rational(1, 2) : Rational(-1);
    default:
      return x;
  }
}

// A rational number and balls around it, each within the next.
struct Nest {
  Rational member;
  Ball narrow, wide;
};

inline Nest nest(RandomData& random) {
  const Rational x = corner(random);
  const std::array<Rational, 4> widths{0, Rational(1, 1000000000), Rational(1, 1000), Rational(1, 5)};
  const Rational w = widths.at(static_cast<std::size_t>(random.between(0, 3.999).get_d()));
  const Rational below = w * random.between(0, 1), above = w * random.between(0, 1);
  return {x, Ball::from_interval(x - below / 2, x + above / 2), Ball::from_interval(x - below, x + above)};
}

// Whether the ball holds the exact value, which is known to 1000 bits.
inline void check_holds(const Ball& value, const Ball& exact) {
  CHECK(value.overlaps(exact));
  if (exact.is_finite() && value.is_finite()) {
    const WorkingPrecision fine(1000);
    const Ball excess = exact.radius() + exact.radius();
    CHECK_FALSE((value.lower() - exact.upper() - excess).is_positive());
    CHECK_FALSE((exact.lower() - excess - value.upper()).is_positive());
  }
}

// At several working precisions the values of the routine, a vector of balls, over the wide and the narrow
// balls hold those at the members. The routine takes one ball for each nest.
template <class Routine>
void check_contains_member(const std::vector<Nest>& arguments, const Routine& routine) {
  const auto over = [&](const auto& ball) {
    std::vector<Ball> balls;
    for (const Nest& nest : arguments) {
      balls.push_back(ball(nest));
    }
    return routine(balls);
  };
  std::vector<Ball> exact;
  {
    const WorkingPrecision fine(1000);
    exact = over([](const Nest& nest) { return Ball(nest.member); });
  }
  for (const long bits : {64L, 128L, 256L, 1024L}) {
    const WorkingPrecision precision(bits);
    CAPTURE(bits);
    const std::vector<Ball> narrow = over([](const Nest& nest) { return nest.narrow; });
    const std::vector<Ball> wide = over([](const Nest& nest) { return nest.wide; });
    for (std::size_t i = 0; i < exact.size(); ++i) {
      CAPTURE(i);
      check_holds(narrow[i], exact[i]);
      check_holds(wide[i], exact[i]);
      CHECK(wide[i].overlaps(narrow[i]));
    }
  }
}

}  // namespace stickslip::examples
