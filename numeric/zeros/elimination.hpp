// Linear unknowns eliminated from more equations than unknowns: each row of an R × (U + 1) matrix, U < R,
// says row · (u, 1) = 0.
//
// The rows are first combined so that their midpoints become the unit matrix above zeros; then elimination
// needs no pivoting and loses little. What remains are R - U equations without u.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "numeric/scalars/hardware_ball.hpp"
#include "numeric/scalars/jet.hpp"
#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::zeros {

// The combinations of rows that do so for these entries, nearly: a proposal in double. Nothing when the first
// U columns are dependent or not finite.
template <int R, int C, class S>
[[nodiscard]] std::optional<Eigen::Matrix<double, R, R>> proposed_combinations(
    const Eigen::Matrix<S, R, C>& rows) {
  const std::optional<Eigen::MatrixXd> found = row_combinations(in_double(rows.template leftCols<C - 1>()));
  return found ? std::optional<Eigen::Matrix<double, R, R>>(*found) : std::nullopt;
}

// The same of the first U columns, over a box: the rows are divided by how wide they are, so that of the
// pivots those are taken that are known best, and little of what is wide is added to other rows.
template <int U, int R, int C, int N, class S>
[[nodiscard]] std::optional<Eigen::Matrix<double, R, R>> proposed_combinations(
    const Eigen::Matrix<S, R, C>& at_m, const Eigen::Matrix<scalars::Jet<S, N>, R, C>& over) {
  Eigen::MatrixXd part(R, U);
  Eigen::Matrix<double, R, 1> scale;
  for (int i = 0; i < R; ++i) {
    double widest = 0;
    for (int j = 0; j < C; ++j) {
      widest = std::max(widest, over(i, j).value.radius());
    }
    scale(i) = widest > 0 ? 1 / widest : 1;
    for (int j = 0; j < U; ++j) {
      part(i, j) = at_m(i, j).approximate() * scale(i);
    }
  }
  const std::optional<Eigen::MatrixXd> found = row_combinations(part);
  return found ? std::optional<Eigen::Matrix<double, R, R>>(*found * scale.asDiagonal()) : std::nullopt;
}

// combinations · rows, over balls or what is made of them.
template <class T, int R, int C, class S>
[[nodiscard]] Eigen::Matrix<T, R, C> combined_rows(const Eigen::Matrix<S, R, R>& combinations,
                                                   const Eigen::Matrix<T, R, C>& rows) {
  Eigen::Matrix<T, R, C> result;
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) {
      for (int k = 0; k < R; ++k) {
        if (!is_zero(rows(k, j))) {
          add_product(result(i, j), combinations(i, k), rows(k, j));
        }
      }
    }
  }
  return result;
}

namespace detail {

// The balls of a scalar, one after the other.
template <class T>
struct BallsOf {
  static constexpr int count = 1;
  [[nodiscard]] static scalars::HardwareBall& at(T& x, int /*i*/) { return x; }
};
template <int N>
struct BallsOf<scalars::Jet<scalars::HardwareBall, N>> {
  static constexpr int count = 1 + N;
  [[nodiscard]] static scalars::HardwareBall& at(scalars::Jet<scalars::HardwareBall, N>& x, int i) {
    return i == 0 ? x.value : x.partials[static_cast<std::size_t>(i - 1)];
  }
};

}  // namespace detail

// The same of exact combinations, over hardware balls or jets over them, as two products of matrices of
// doubles: that of the midpoints m and that of the sizes |a| of the combinations with radii. In whatever
// order they are added up, R <= 12 products a m come out wrong by at most 12 · 2^-53/(1 - 12 · 2^-53)
// < 2^-49 times the sum of |a m|, and by 2^-1075 for each that underflows. So r + 2^-49 |m| is taken for the
// radius r. What is taken for radii is rounded at most sixteen times, so a factor 1 + 2^-48 puts it above the
// exact sum; 2^-1000, added before and after, exceeds what underflows there. A sum of exact zeros is exactly
// zero; |m| 2^-53 of the result is infinite where that is.
template <class T, int R, int C>
requires std::is_same_v<T, scalars::HardwareBall> ||(detail::BallsOf<T>::count > 1)
    [[nodiscard]] Eigen::Matrix<T, R, C> combined_rows(const Eigen::Matrix<double, R, R>& combinations,
                                                       Eigen::Matrix<T, R, C> rows) {
  static_assert(R <= 12);
  using Balls = detail::BallsOf<T>;
  Eigen::Matrix<double, R, C * Balls::count> mid, rad;
  Eigen::Array<bool, 1, C * Balls::count> is_zero_column;
  for (int j = 0; j < C; ++j) {
    for (int part = 0; part < Balls::count; ++part) {
      const int column = j * Balls::count + part;
      double largest = 0;
      for (int k = 0; k < R; ++k) {
        const scalars::HardwareBall& x = Balls::at(rows(k, j), part);
        const double size = std::abs(x.approximate());
        mid(k, column) = x.approximate();
        rad(k, column) = x.radius() + size * 0x1p-49 + 0x1p-1000;
        largest += size + x.radius();
      }
      is_zero_column(column) = largest == 0;
    }
  }
  const Eigen::Matrix<double, R, C * Balls::count> mids = combinations.lazyProduct(mid);
  const Eigen::Matrix<double, R, R> sizes = combinations.cwiseAbs();
  const Eigen::Matrix<double, R, C * Balls::count> rads = sizes.lazyProduct(rad);
  for (int j = 0; j < C; ++j) {
    for (int part = 0; part < Balls::count; ++part) {
      const int column = j * Balls::count + part;
      for (int i = 0; i < R; ++i) {
        const double m = mids(i, column);
        Balls::at(rows(i, j), part) =
            is_zero_column(column)
                ? scalars::HardwareBall(0)
                : scalars::HardwareBall(
                      m, (rads(i, column) + (std::abs(m) * 0x1p-53 + 0x1p-1000)) * (1 + 0x1p-48));
      }
    }
  }
  return rows;
}

namespace detail {

// sum -= a b; of jets over hardware balls with one rounding for each partial.
template <class T>
void subtract_product(T& sum, const T& a, const T& b) {
  sum -= a * b;
}
template <int N>
void subtract_product(scalars::Jet<scalars::HardwareBall, N>& sum,
                      const scalars::Jet<scalars::HardwareBall, N>& a,
                      const scalars::Jet<scalars::HardwareBall, N>& b) {
  for (std::size_t i = 0; i < sum.partials.size(); ++i) {
    add_products(sum.partials[i], -a.value, b.partials[i], -a.partials[i], b.value);
  }
  add_product(sum.value, -a.value, b.value);
}

}  // namespace detail

// Eliminates the unknowns from, …, to - 1 from the rows below their own, without pivoting. False when a pivot
// may vanish; then the rows are meaningless.
template <class T, int R, int C>
[[nodiscard]] bool eliminate(Eigen::Matrix<T, R, C>& m, int from, int to) {
  for (int k = from; k < to; ++k) {
    if (!is_nonzero(m(k, k))) {
      return false;
    }
    const T reciprocal = T(1) / m(k, k);
    for (int i = k + 1; i < R; ++i) {
      if (is_zero(m(i, k))) {
        continue;
      }
      const T factor = m(i, k) * reciprocal;
      for (int j = k + 1; j < C; ++j) {
        detail::subtract_product(m(i, j), factor, m(k, j));
      }
    }
  }
  return true;
}

// u, once all unknowns are eliminated.
template <class T, int R, int C>
[[nodiscard]] Eigen::Matrix<T, C - 1, 1> back_substituted(const Eigen::Matrix<T, R, C>& m) {
  Eigen::Matrix<T, C - 1, 1> u;
  for (int k = C - 2; k >= 0; --k) {
    T sum = m(k, C - 1);
    for (int j = k + 1; j < C - 1; ++j) {
      sum += m(k, j) * u(j);
    }
    u(k) = -sum / m(k, k);
  }
  return u;
}

// The jets' values replaced by their mean value forms about m, where those are narrower.
template <int R, int C, int N, class S>
void sharpen(Eigen::Matrix<scalars::Jet<S, N>, R, C>& jets, const Eigen::Matrix<S, R, C>& at_m,
             const Eigen::Matrix<std::type_identity_t<S>, N, 1>& spread) {
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) {
      S form = at_m(i, j);
      for (int k = 0; k < N; ++k) {
        add_product(form, jets(i, j).partials[static_cast<std::size_t>(k)], spread(k));
      }
      jets(i, j).value = intersection(form, jets(i, j).value).value_or(form);
    }
  }
}

}  // namespace stickslip::numeric::zeros
