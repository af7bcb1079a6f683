// Linear unknowns eliminated from more equations than unknowns: each row of an R × (U + 1) matrix, U < R,
// says row · (u, 1) = 0.
//
// The rows are first combined so that their midpoints become the unit matrix above zeros; then elimination
// needs no pivoting and loses little. What remains are R - U equations without u.
#pragma once

#include <Eigen/Core>
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
[[nodiscard]] std::optional<Eigen::Matrix<S, R, R>> proposed_combinations(
    const Eigen::Matrix<S, R, C>& rows) {
  const std::optional<Eigen::MatrixXd> found = row_combinations(in_double(rows.template leftCols<C - 1>()));
  if (!found) {
    return std::nullopt;
  }
  return Eigen::Matrix<S, R, R>(found->template cast<S>());
}

namespace detail {

// Sums of constants times balls, or times jets over them.
template <class T>
struct Combination {
  T total;

  template <class S>
  void add(const S& factor, const T& x) {
    add_product(total, factor, x);
  }
  [[nodiscard]] const T& sum() const { return total; }
};
template <>
struct Combination<scalars::HardwareBall> : scalars::ProductSum {};
template <int N>
struct Combination<scalars::Jet<scalars::HardwareBall, N>> {
  scalars::ProductSum value;
  std::array<scalars::ProductSum, static_cast<std::size_t>(N)> partials;

  void add(const scalars::HardwareBall& factor, const scalars::Jet<scalars::HardwareBall, N>& x) {
    value.add(factor, x.value);
    for (std::size_t i = 0; i < partials.size(); ++i) {
      partials[i].add(factor, x.partials[i]);
    }
  }
  [[nodiscard]] scalars::Jet<scalars::HardwareBall, N> sum() const {
    scalars::Jet<scalars::HardwareBall, N> total;
    total.value = value.sum();
    for (std::size_t i = 0; i < partials.size(); ++i) {
      total.partials[i] = partials[i].sum();
    }
    return total;
  }
};

template <class T>
void subtract_product(T& sum, const T& a, const T& b) {
  sum -= a * b;
}
template <int N>
void subtract_product(scalars::Jet<scalars::HardwareBall, N>& sum,
                      const scalars::Jet<scalars::HardwareBall, N>& a,
                      const scalars::Jet<scalars::HardwareBall, N>& b) {
  for (std::size_t i = 0; i < sum.partials.size(); ++i) {
    scalars::ProductSum slope(sum.partials[i]);
    slope.add(-a.value, b.partials[i]);
    slope.add(-a.partials[i], b.value);
    sum.partials[i] = slope.sum();
  }
  sum.value -= a.value * b.value;
}

}  // namespace detail

// combinations · rows, over balls or jets over balls.
template <class T, int R, int C, class S>
[[nodiscard]] Eigen::Matrix<T, R, C> combined_rows(const Eigen::Matrix<S, R, R>& combinations,
                                                   const Eigen::Matrix<T, R, C>& rows) {
  static_assert(R <= 12);  // see ProductSum
  Eigen::Matrix<T, R, C> result;
  for (int j = 0; j < C; ++j) {
    std::array<detail::Combination<T>, R> column{};
    for (int k = 0; k < R; ++k) {
      if (!is_zero(rows(k, j))) {
        for (int i = 0; i < R; ++i) {
          column[static_cast<std::size_t>(i)].add(combinations(i, k), rows(k, j));
        }
      }
    }
    for (int i = 0; i < R; ++i) {
      result(i, j) = column[static_cast<std::size_t>(i)].sum();
    }
  }
  return result;
}

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
