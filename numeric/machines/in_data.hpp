// Functions of some data s_1, s_2, …, each of them between -1 and 1, as polynomials of the second degree with
// balls as coefficients, and a ball that holds what these leave out.
//
// With s_0 = 1 the monomials are s_j s_k, 0 <= j <= k, in the order 1; s_1, s_1²; s_2, s_1 s_2, s_2²; … So a
// function of fewer data is one of more. A coefficient that is none, a ball that is 0 or a matrix without
// entries, is zero.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "core/sinc.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

[[nodiscard]] inline bool is_none(const Ball& x) {
  return is_zero(x);
}
template <class M>
[[nodiscard]] bool is_none(const M& A) {
  return A.size() == 0;
}
template <class M>
void add(M& sum, const M& x) {
  if (is_none(sum)) {
    sum = x;
  } else if (!is_none(x)) {
    sum += x;
  }
}

// s_j s_k, j <= k.
struct Monomial {
  std::size_t j, k;

  [[nodiscard]] std::size_t place() const { return k * (k + 1) / 2 + j; }
  [[nodiscard]] std::size_t degree() const { return (j > 0 ? 1 : 0) + (k > 0 ? 1 : 0); }
  // For all s.
  [[nodiscard]] Ball range() const {
    return k == 0 ? Ball(1) : Ball::hull(Ball(j == k ? 0 : -1), Ball(1));
  }
};
[[nodiscard]] constexpr std::size_t monomials(std::size_t data) {
  return (data + 1) * (data + 2) / 2;
}
[[nodiscard]] constexpr Monomial monomial(std::size_t place) {
  std::size_t k = 0;
  while (monomials(k) <= place) {
    ++k;
  }
  return {place - k * (k + 1) / 2, k};
}

template <class M>
struct InData {
  std::vector<M> c;  // of all monomials of some data
  M rest{};          // for each s some member of it is left

  InData() = default;
  explicit InData(const M& constant) : c{constant} {}
  // The last ones may be left out.
  explicit InData(std::vector<M> coefficients) : c(std::move(coefficients)) {
    c.resize(monomials(monomial(c.size() - 1).k));
  }

  // The sum of the parts of these degrees, for all s.
  [[nodiscard]] M part(std::size_t lowest, std::size_t highest) const {
    M sum{};
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Monomial m = monomial(i);
      if (m.degree() >= lowest && m.degree() <= highest && !is_none(c[i])) {
        machines::add(sum, i == 0 ? c[i] : M(c[i] * m.range()));
      }
    }
    return sum;
  }
  // Contains it for all s.
  [[nodiscard]] M all() const {
    M all = part(0, 2);
    machines::add(all, rest);
    return all;
  }
  // Contains it at these s.
  [[nodiscard]] M at(const std::vector<Ball>& s) const {
    const auto factor = [&](std::size_t k) { return k == 0 ? Ball(1) : s.at(k - 1); };
    M sum = rest;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Monomial m = monomial(i);
      if (!is_none(c[i])) {
        machines::add(sum, M(c[i] * Ball(factor(m.j) * factor(m.k))));
      }
    }
    return sum;
  }
  InData& operator+=(const InData& other) {
    c.resize(std::max(c.size(), other.c.size()));
    for (std::size_t i = 0; i < other.c.size(); ++i) {
      machines::add(c[i], other.c[i]);
    }
    machines::add(rest, other.rest);
    return *this;
  }
};

// linear(f), of a function that maps 0 to 0.
template <class M, class Linear>
[[nodiscard]] auto mapped(const InData<M>& f, const Linear& linear) {
  InData<std::decay_t<decltype(linear(f.rest))>> result;
  result.c.resize(f.c.size());
  for (std::size_t i = 0; i < f.c.size(); ++i) {
    if (!is_none(f.c[i])) {
      result.c[i] = linear(f.c[i]);
    }
  }
  if (!is_none(f.rest)) {
    result.rest = linear(f.rest);
  }
  return result;
}
template <class M>
[[nodiscard]] InData<M> operator*(const InData<M>& f, const Ball& factor) {
  return mapped(f, [&](const M& x) { return M(x * factor); });
}

// times(f, g), bilinear; what is of a higher degree is part of the rest.
template <class A, class B, class Times>
[[nodiscard]] auto product(const InData<A>& f, const InData<B>& g, const Times& times) {
  using M = std::decay_t<decltype(times(f.rest, g.rest))>;
  InData<M> result;
  result.c.resize(std::max(f.c.size(), g.c.size()));
  const auto into = [&](M& sum, const A& x, const B& y) {
    if (!is_none(x) && !is_none(y)) {
      add(sum, M(times(x, y)));
    }
  };
  for (std::size_t a = 0; a < f.c.size(); ++a) {
    const Monomial of_f = monomial(a);
    for (std::size_t b = 0; b < g.c.size(); ++b) {
      const Monomial of_g = monomial(b);
      if (of_f.degree() + of_g.degree() <= 2) {
        const auto [j, k] = of_f.degree() == 0   ? of_g
                            : of_g.degree() == 0 ? of_f
                                                 : Monomial{std::min(of_f.k, of_g.k), std::max(of_f.k, of_g.k)};
        into(result.c[Monomial{j, k}.place()], f.c[a], g.c[b]);
      }
    }
  }
  if (f.c.size() > 1 && g.c.size() > 1) {
    into(result.rest, f.part(1, 1), g.part(2, 2));
    into(result.rest, f.part(2, 2), g.part(1, 2));
  }
  if (!is_none(f.rest)) {
    into(result.rest, f.rest, g.all());
  }
  if (!is_none(g.rest)) {
    into(result.rest, f.part(0, 2), g.rest);
  }
  return result;
}
[[nodiscard]] inline InData<Ball> operator*(const InData<Ball>& f, const InData<Ball>& g) {
  return product(f, g, [](const Ball& x, const Ball& y) { return Ball(x * y); });
}
// Of matrices.
template <class M>
[[nodiscard]] InData<M> operator*(const InData<M>& f, const InData<M>& g) {
  return product(f, g, [](const M& x, const M& y) { return M(zeros::product(x, y)); });
}

// The polynomial of the second degree that has these values at the places of its monomials: at 0 for 1, e_k
// for s_k, -e_k for s_k² and e_j + e_k for s_j s_k, e the units. A coefficient that may be zero is part of the
// rest: most are.
template <class M>
[[nodiscard]] InData<M> through(const std::vector<M>& values) {
  const auto may_be_zero = [](const M& x) {
    if constexpr (std::is_same_v<M, Ball>) {
      return x.contains_zero();
    } else {
      return std::all_of(x.data(), x.data() + x.size(), [](const Ball& y) { return y.contains_zero(); });
    }
  };
  InData<M> f(values.front());
  f.c.resize(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto [j, k] = monomial(i);
    const M &at_k = values[Monomial{0, k}.place()], &other = values[j == 0 ? Monomial{k, k}.place() : i];
    M x;
    if (j == 0) {
      x = (at_k - other) * Ball(0.5);
    } else if (j == k) {
      x = (at_k + other) * Ball(0.5) - values[0];
    } else {
      x = other - at_k - values[Monomial{0, j}.place()] + values[0];
    }
    if (may_be_zero(x)) {
      add(f.rest, M(x * monomial(i).range()));
    } else {
      f.c[i] = x;
    }
  }
  return f;
}

// 1/(a + d) = (1 - q + q² - q³/(1 + q))/a with q = d/a. Not finite unless a + d has no zero.
[[nodiscard]] inline InData<Ball> reciprocal(const InData<Ball>& f) {
  const Ball one = Ball(1) / f.c[0];
  InData<Ball> q = f;
  q.c[0] = Ball(0);
  q = q * one;
  const Ball all = q.all();
  InData<Ball> result = q * q;
  result += q * Ball(-1);
  result.c[0] += Ball(1);
  result.rest -= all * all * all / (Ball(1) + all);
  return result * one;
}

// Sine and cosine of a + d by those of d to the third order, with |cos d - 1 + d²/2| <= d⁴/24 and
// |sin d - d| <= |d|³/6.
[[nodiscard]] inline std::pair<InData<Ball>, InData<Ball>> sin_cos(const InData<Ball>& f) {
  const auto [sine, cosine] = sin_cos(f.c[0]);
  InData<Ball> d = f;
  d.c[0] = Ball(0);
  const Ball most = abs(d.all()).upper(), both = Ball::hull(Ball(-1), Ball(1));
  InData<Ball> sin_d = d, cos_d = d * d * Ball(-0.5);
  cos_d.c[0] += Ball(1);
  sin_d.rest += both * most * most * most / Ball(6);
  cos_d.rest += both * most * most * most * most / Ball(24);
  InData<Ball> sine_of_f = cos_d * sine, cosine_of_f = cos_d * cosine;
  sine_of_f += sin_d * cosine;
  cosine_of_f += sin_d * Ball(-sine);
  return {sine_of_f, cosine_of_f};
}

}  // namespace stickslip::numeric::machines
