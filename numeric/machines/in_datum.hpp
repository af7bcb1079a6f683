// Functions of s, -1 <= s <= 1, as polynomials of the third degree with balls as coefficients.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "core/ball.hpp"

namespace stickslip::numeric::machines {

// c[0] + c[1] s + c[2] s² + c[3] s³ with, for each s, some members of the balls.
template <class M>
struct InDatum {
  std::array<M, 4> c;

  // Contains it for all s.
  [[nodiscard]] M all() const {
    const Ball odd = Ball::hull(Ball(-1), Ball(1)), even = Ball::hull(Ball(0), Ball(1));
    M all = c[0];
    all += c[1] * odd;
    all += c[2] * even;
    all += c[3] * odd;
    return all;
  }
  InDatum& operator+=(const InDatum& other) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      c[i] += other.c[i];
    }
    return *this;
  }
  InDatum& operator-=(const InDatum& other) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      c[i] -= other.c[i];
    }
    return *this;
  }
};

// times(f, g) of the coefficients; powers beyond the third are, for each s, so much of the third.
template <class A, class B, class Times>
[[nodiscard]] auto product(const InDatum<A>& f, const InDatum<B>& g, const Times& times) {
  InDatum<std::decay_t<decltype(times(f.c[0], g.c[0]))>> result;
  for (std::size_t k = 0; k < 4; ++k) {
    result.c[k] = times(f.c[0], g.c[k]);
  }
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (i + k <= 3) {
        result.c[i + k] += times(f.c[i], g.c[k]);
      } else {
        result.c[3] += times(f.c[i], g.c[k]) * Ball::hull(Ball((i + k) % 2 == 0 ? -1 : 0), Ball(1));
      }
    }
  }
  return result;
}
[[nodiscard]] inline InDatum<Ball> operator*(const InDatum<Ball>& f, const InDatum<Ball>& g) {
  return product(f, g, [](const Ball& x, const Ball& y) { return Ball(x * y); });
}

}  // namespace stickslip::numeric::machines
