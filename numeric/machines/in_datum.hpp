// Functions of s, -1 <= s <= 1, as polynomials of the third degree with balls as coefficients.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/ball.hpp"
#include "core/sinc.hpp"

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

// 1/(a + b s) = (1 - q s + q² s² - q³ s³/(1 + q s))/a with q = b/a. Not finite unless |q| < 1.
[[nodiscard]] inline InDatum<Ball> reciprocal(const Ball& a, const Ball& b) {
  const Ball one = Ball(1) / a, q = b / a, rest = Ball(1) / (Ball(1) + q * Ball::hull(Ball(-1), Ball(1)));
  return {{one, -one * q, one * q * q, -one * q * q * q * rest}};
}

// Sine and cosine of f_0 + d, d = s (f_1 + f_2 s + f_3 s²), by those of d to the third order, with
// |cos d - 1 + d²/2| <= d⁴/24 and |sin d - d + d³/6| <= |d|⁵/120.
[[nodiscard]] inline std::pair<InDatum<Ball>, InDatum<Ball>> sin_cos(const InDatum<Ball>& f) {
  const auto [sine, cosine] = sin_cos(f.c[0]);
  const InDatum<Ball> d{{Ball(0), f.c[1], f.c[2], f.c[3]}}, square = d * d, cube = square * d;
  const Ball most = abs(d.c[1]) + abs(d.c[2]) + abs(d.c[3]);
  const Ball fourth = most * most * most * most * Ball::hull(Ball(-1), Ball(1));
  InDatum<Ball> sin_d = d, cos_d = square;
  for (std::size_t i = 0; i < 4; ++i) {
    sin_d.c[i] -= cube.c[i] / Ball(6);
    cos_d.c[i] *= Ball(-0.5);
  }
  cos_d.c[0] += Ball(1);
  cos_d.c[3] += fourth / Ball(24);
  sin_d.c[3] += fourth * most / Ball(120);
  InDatum<Ball> sine_of_f = sin_d, cosine_of_f = cos_d;
  for (std::size_t i = 0; i < 4; ++i) {
    sine_of_f.c[i] = sine * cos_d.c[i] + cosine * sin_d.c[i];
    cosine_of_f.c[i] = cosine * cos_d.c[i] - sine * sin_d.c[i];
  }
  return {sine_of_f, cosine_of_f};
}

}  // namespace stickslip::numeric::machines
