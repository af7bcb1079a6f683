// Functions of some data s_1, s_2, …, each of them between -1 and 1, as polynomials of the third degree with
// balls as coefficients, and a ball that holds what these leave out.
//
// With s_0 = 1 the monomials are s_i s_j s_k, i <= j <= k, in an order in which those of fewer data come
// first: so a function of some data is one of more. A coefficient that is none, a ball that is 0 or a matrix
// without entries, is zero.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "core/sinc.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/scalars/scalars.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

inline constexpr std::size_t most_data = 8;
inline constexpr std::size_t highest_degree = 3;

struct Monomial {
  std::array<std::size_t, highest_degree> of{};  // rising

  [[nodiscard]] constexpr std::size_t place() const {
    return of[0] + of[1] * (of[1] + 1) / 2 + of[2] * (of[2] + 1) * (of[2] + 2) / 6;
  }
  [[nodiscard]] constexpr std::size_t degree() const {
    return (of[0] > 0 ? 1U : 0U) + (of[1] > 0 ? 1U : 0U) + (of[2] > 0 ? 1U : 0U);
  }
  // For all s between -1, or 0, and 1.
  [[nodiscard]] constexpr bool is_positive() const { return of[0] == 0 && of[1] == of[2]; }
  [[nodiscard]] Ball range() const {
    return degree() == 0 ? Ball(1) : Ball::hull(Ball(is_positive() ? 0 : -1), Ball(1));
  }
  // Assumes that the degrees are together at most the highest.
  friend Monomial operator*(const Monomial& a, const Monomial& b) {
    Monomial product = a;
    for (std::size_t l = highest_degree, free = highest_degree - a.degree(); l-- > 0 && b.of[l] > 0;) {
      product.of[--free] = b.of[l];
    }
    std::ranges::sort(product.of);
    return product;
  }
};
// s_k, k >= 1.
[[nodiscard]] constexpr std::size_t place_of(std::size_t k) {
  return Monomial{{0, 0, k}}.place();
}
// Of so many data.
[[nodiscard]] constexpr std::size_t monomials(std::size_t data) {
  return (data + 1) * (data + 2) * (data + 3) / 6;
}
// At most of `most_data`.
[[nodiscard]] inline const Monomial& monomial(std::size_t place) {
  static const std::vector<Monomial> all = [] {
    std::vector<Monomial> found;
    for (std::size_t k = 0; k <= most_data; ++k) {
      for (std::size_t j = 0; j <= k; ++j) {
        for (std::size_t i = 0; i <= j; ++i) {
          found.push_back({{i, j, k}});
        }
      }
    }
    return found;
  }();
  return all.at(place);
}

// Of the products of a monomial with the others in order.
inline constexpr std::size_t too_high = monomials(most_data);  // of too high a degree
[[nodiscard]] inline const std::vector<std::size_t>& places_of_products(std::size_t place) {
  static const std::vector<std::vector<std::size_t>> all = [] {
    constexpr std::size_t count = monomials(most_data);
    std::vector<std::vector<std::size_t>> found(count, std::vector<std::size_t>(count, too_high));
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        if (monomial(a).degree() + monomial(b).degree() <= highest_degree) {
          found[a][b] = (monomial(a) * monomial(b)).place();
        }
      }
    }
    return found;
  }();
  return all.at(place);
}

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

// Adds x times the monomial, for all s.
inline void add_range(Ball& sum, const Ball& x, const Monomial& m) {
  if (is_zero(x)) {
    return;
  }
  Ball spread = x;  // about 0 or x/2
  if (m.is_positive()) {
    if (m.degree() > 0) {
      arb_mul_2exp_si(spread.raw(), spread.raw(), -1);
    }
    sum += spread;
  }
  if (m.degree() > 0) {
    arb_add_error(sum.raw(), spread.raw());
  }
}
template <class M>
void add_range(M& sum, const M& x, const Monomial& m) {
  if (is_none(sum)) {
    sum = M::Constant(x.rows(), x.cols(), Ball(0));
  }
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    add_range(sum.data()[i], x.data()[i], m);
  }
}

template <class M>
struct InData {
  std::vector<M> c;  // of all monomials of some data
  M rest{};          // for each s some member of it is left

  InData() = default;
  explicit InData(const M& constant) : c{constant} {}

  // The parts of each degree, for all s.
  [[nodiscard]] std::array<M, highest_degree + 1> degrees() const {
    std::array<M, highest_degree + 1> sums;
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!is_none(c[i])) {
        add_range(sums[monomial(i).degree()], c[i], monomial(i));
      }
    }
    return sums;
  }
  // Contains it for all s, without the rest and with it.
  [[nodiscard]] M polynomial() const {
    M all = c[0];
    for (std::size_t i = 1; i < c.size(); ++i) {
      if (!is_none(c[i])) {
        add_range(all, c[i], monomial(i));
      }
    }
    return all;
  }
  [[nodiscard]] M all() const {
    M all = polynomial();
    machines::add(all, rest);
    return all;
  }
  // Contains it at these s.
  [[nodiscard]] M at(const std::vector<Ball>& s) const {
    M sum = rest;
    for (std::size_t i = 0; i < c.size(); ++i) {
      Ball value(1);
      for (const std::size_t k : monomial(i).of) {
        value *= k == 0 ? Ball(1) : s.at(k - 1);
      }
      if (!is_none(c[i])) {
        machines::add(sum, M(c[i] * value));
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
  InData& operator-=(const InData& other) { return *this += other * Ball(-1); }
  friend InData operator+(InData a, const InData& b) { return a += b; }
  friend InData operator-(InData a, const InData& b) { return a -= b; }
  friend InData operator-(const InData& a) { return a * Ball(-1); }
};

template <class M>
[[nodiscard]] bool is_none(const InData<M>& f) {
  return is_none(f.rest) && std::ranges::all_of(f.c, [](const M& x) { return is_none(x); });
}

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

// Adds the product of f and g, with add_times(sum, x, y) for those of their coefficients, bilinear and of
// none nothing; what is of a higher degree is part of the rest.
template <class M, class A, class B, class AddTimes>
void add_product(InData<M>& result, const InData<A>& f, const InData<B>& g, const AddTimes& add_times) {
  result.c.resize(std::max({result.c.size(), f.c.size(), g.c.size()}));
  const auto into = [&](M& sum, const A& x, const B& y) {
    if (!is_none(x) && !is_none(y)) {
      add_times(sum, x, y);
    }
  };
  for (std::size_t a = 0; a < f.c.size(); ++a) {
    const std::vector<std::size_t>& places = places_of_products(a);
    for (std::size_t b = 0; b < g.c.size() && !is_none(f.c[a]); ++b) {
      if (places[b] != too_high) {
        into(result.c.at(places[b]), f.c[a], g.c[b]);
      }
    }
  }
  if (f.c.size() > 1 && g.c.size() > 1) {
    const auto of_f = f.degrees();
    const auto of_g = g.degrees();
    B high{};  // of g, so that it and f's part are of a higher degree together
    for (std::size_t degree = 1; degree <= highest_degree; ++degree) {
      add(high, of_g[highest_degree + 1 - degree]);
      into(result.rest, of_f[degree], high);
    }
  }
  if (!is_none(f.rest)) {
    into(result.rest, f.rest, g.all());
  }
  if (!is_none(g.rest)) {
    into(result.rest, f.polynomial(), g.rest);
  }
}
// times(f, g), bilinear.
template <class A, class B, class Times>
[[nodiscard]] auto product(const InData<A>& f, const InData<B>& g, const Times& times) {
  using M = std::decay_t<decltype(times(f.rest, g.rest))>;
  InData<M> result;
  add_product(result, f, g, [&](M& sum, const A& x, const B& y) { add(sum, M(times(x, y))); });
  return result;
}
inline void add_product(InData<Ball>& sum, const InData<Ball>& f, const InData<Ball>& g) {
  add_product(sum, f, g, [](Ball& one, const Ball& x, const Ball& y) { add_product(one, x, y); });
}
[[nodiscard]] inline InData<Ball> operator*(const InData<Ball>& f, const InData<Ball>& g) {
  InData<Ball> result;
  add_product(result, f, g);
  return result;
}
// Of matrices.
template <class M>
[[nodiscard]] InData<M> operator*(const InData<M>& f, const InData<M>& g) {
  return product(f, g, [](const M& x, const M& y) { return M(zeros::product(x, y)); });
}

// x, a matrix or a number, as the rows from that one on of a matrix of so many that is zero else.
template <class M>
[[nodiscard]] M placed(const M& x, Eigen::Index from, Eigen::Index rows) {
  M A = M::Constant(rows, x.cols(), Ball(0));
  A.middleRows(from, x.rows()) = x;
  return A;
}
[[nodiscard]] inline model::VectorX<Ball> placed(const Ball& x, Eigen::Index from, Eigen::Index rows) {
  model::VectorX<Ball> A = model::VectorX<Ball>::Constant(rows, Ball(0));
  A(from) = x;
  return A;
}

// The matrix of these functions.
template <class Entries>
[[nodiscard]] InData<model::MatrixX<Ball>> together(const Eigen::MatrixBase<Entries>& entries) {
  using Matrix = model::MatrixX<Ball>;
  InData<Matrix> A(Matrix::Constant(entries.rows(), entries.cols(), Ball(0)));
  const auto put = [&](Matrix& into, Eigen::Index i, Eigen::Index k, const Ball& x) {
    if (!is_none(x)) {
      if (is_none(into)) {
        into = Matrix::Constant(entries.rows(), entries.cols(), Ball(0));
      }
      into(i, k) = x;
    }
  };
  for (Eigen::Index i = 0; i < entries.rows(); ++i) {
    for (Eigen::Index k = 0; k < entries.cols(); ++k) {
      const InData<Ball>& f = entries(i, k);
      A.c.resize(std::max(A.c.size(), f.c.size()));
      for (std::size_t place = 0; place < f.c.size(); ++place) {
        put(A.c[place], i, k, f.c[place]);
      }
      put(A.rest, i, k, f.rest);
    }
  }
  return A;
}

// The functions that the entries of the matrix are.
[[nodiscard]] inline model::MatrixX<InData<Ball>> entries(const InData<model::MatrixX<Ball>>& A) {
  using Matrix = model::MatrixX<Ball>;
  model::MatrixX<InData<Ball>> all(A.c[0].rows(), A.c[0].cols());
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    for (Eigen::Index k = 0; k < all.cols(); ++k) {
      all(i, k) = mapped(A, [&](const Matrix& x) { return x(i, k); });
    }
  }
  return all;
}

// 1/(a + d) = (1 - q + q² - q³ + q⁴/(1 + q))/a with q = d/a. Not finite unless a + d has no zero.
[[nodiscard]] inline InData<Ball> reciprocal(const InData<Ball>& f) {
  const Ball one = Ball(1) / f.c[0];
  InData<Ball> q = f;
  q.c[0] = Ball(0);
  q = q * one;
  const Ball all = q.all();
  InData<Ball> power = q, result = q * Ball(-1);
  for (const int sign : {1, -1}) {
    power = power * q;
    result += power * Ball(sign);
  }
  result.c[0] += Ball(1);
  result.rest += all * all * all * all / (Ball(1) + all);
  return result * one;
}

[[nodiscard]] inline InData<Ball> operator/(const InData<Ball>& f, const InData<Ball>& g) {
  return f * reciprocal(g);
}

// That of a + d by that of d, with |exp d - 1 - d - d²/2 - d³/6| <= |d|⁴ exp |d|/24.
[[nodiscard]] inline InData<Ball> exp(const InData<Ball>& f) {
  InData<Ball> d = f;
  d.c[0] = Ball(0);
  const Ball most = abs(d.all()).upper(), fourth = most * most * most * most;
  const InData<Ball> square = d * d;
  InData<Ball> exp_d = d + square * Ball(0.5) + square * d * (Ball(1) / Ball(6));
  exp_d.c[0] += Ball(1);
  exp_d.rest += fourth * exp(most) / Ball(24) * Ball::hull(Ball(-1), Ball(1));
  return exp_d * exp(f.c[0]);
}

// Sine and cosine of a + d by those of d, with |cos d - 1 + d²/2| <= d⁴/24 and
// |sin d - d + d³/6| <= |d|⁵/120.
[[nodiscard]] inline std::pair<InData<Ball>, InData<Ball>> sin_cos(const InData<Ball>& f) {
  const auto [sine, cosine] = sin_cos(f.c[0]);
  InData<Ball> d = f;
  d.c[0] = Ball(0);
  const Ball most = abs(d.all()).upper(), fourth = most * most * most * most * Ball::hull(Ball(-1), Ball(1));
  const InData<Ball> square = d * d;
  InData<Ball> sin_d = d, cos_d = square * Ball(-0.5);
  sin_d += square * d * (Ball(-1) / Ball(6));
  sin_d.rest += fourth * most / Ball(120);
  cos_d.c[0] += Ball(1);
  cos_d.rest += fourth / Ball(24);
  InData<Ball> sine_of_f = cos_d * sine, cosine_of_f = cos_d * cosine;
  sine_of_f += sin_d * cosine;
  cosine_of_f += sin_d * Ball(-sine);
  return {sine_of_f, cosine_of_f};
}

}  // namespace stickslip::numeric::machines
