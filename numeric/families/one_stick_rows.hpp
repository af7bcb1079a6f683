// The rows of one_stick_closing.hpp, and what is left of them once the amplitudes are eliminated: for its
// source file.
#pragma once

#include <array>

#include "numeric/families/one_stick_closing.hpp"
#include "numeric/zeros/elimination.hpp"

namespace stickslip::numeric::families {

inline constexpr int amplitudes = 3;  // columns to be eliminated

template <class T, int R, int N, Datum G>
using RowsOf = Eigen::Matrix<T, R, OneStick<N, G>::columns>;
template <class T, int N, Datum G>
using AllRows = RowsOf<T, OneStick<N, G>::rows, N, G>;
// What is left of them once the amplitudes are eliminated.
template <class T, int N, Datum G>
using LoadRows = Eigen::Matrix<T, OneStick<N, G>::left, OneStick<N, G>::loads>;

template <class T, class S>
OneStickData<T> lifted(const OneStickData<S>& data) {
  return {model::lift<T>(data.d), T(data.given)};
}

// tau and tau1, which is 0 with one time.
template <class T, int N>
std::pair<T, T> both_times(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  const Eigen::Matrix<T, N, 1> t = times<T, N>(data.d.Theta, x);
  return {t(0), N == 2 ? t(N - 1) : T(0)};
}

template <int N, Datum G, class T, std::size_t R>
RowsOf<T, static_cast<int>(R), N, G> as_matrix(const OneStickData<T>& data, const T& total,
                                               const std::array<model::OvershootingRow<T>, R>& all) {
  RowsOf<T, static_cast<int>(R), N, G> m;
  if constexpr (G == Datum::phase) {
    const std::pair<T, T> psi = sin_cos(T(data.given + data.d.omega * total / T(2)));
    for (std::size_t i = 0; i < R; ++i) {
      T one = all[i].one;
      if (!is_zero(all[i].cos_psi)) {
        one += all[i].cos_psi * psi.second;
      }
      if (!is_zero(all[i].sin_psi)) {
        one += all[i].sin_psi * psi.first;
      }
      m.row(static_cast<int>(i)) << all[i].a, all[i].C, all[i].D, one;
    }
  } else {
    for (std::size_t i = 0; i < R; ++i) {
      const model::OvershootingRow<T>& row = all[i];
      m.row(static_cast<int>(i)) << row.a, row.C, row.D, row.cos_psi, row.sin_psi, row.one;
    }
  }
  return m;
}

// The data for the rows of a motion's two halves: with one time the friction does not turn.
template <class T, int N>
model::OvershootingData<T> of_halves(const model::OvershootingData<T>& d) {
  model::OvershootingData<T> result = d;
  if (N == 1) {
    result.us = T(0);
  }
  return result;
}

// odd_1 and odd_2: their columns a, D and cos psi are zero.
template <int N, Datum G, class T>
RowsOf<T, 2, N, G> odd_rows(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  const auto [tau, tau1] = both_times<T, N>(data, x);
  return as_matrix<N, G>(data, T(tau + tau1), model::overshooting_odd<T>(of_halves<T, N>(data.d), tau, tau1));
}

// even_1, even_2, with two times the turn, and where ur is given (12).
template <int N, Datum G, class T>
RowsOf<T, OneStick<N, G>::rows - 2, N, G> other_rows(const OneStickData<T>& data,
                                                     const Eigen::Matrix<T, N, 1>& x) {
  const auto [tau, tau1] = both_times<T, N>(data, x);
  const auto [even1, even2] = model::overshooting_even<T>(of_halves<T, N>(data.d), tau, tau1);
  std::array<model::OvershootingRow<T>, OneStick<N, G>::rows - 2> all;
  all[0] = even1;
  all[1] = even2;
  if constexpr (N == 2) {
    all[2] = model::overshooting_turn<T>(data.d, tau, tau1);
  }
  if constexpr (G == Datum::friction) {
    all.back() = model::overshooting_friction<T>(data.d, data.given, tau, tau1);
  }
  return as_matrix<N, G>(data, T(tau + tau1), all);
}

template <int N, Datum G, class T>
AllRows<T, N, G> stacked(const RowsOf<T, 2, N, G>& odd,
                         const RowsOf<T, OneStick<N, G>::rows - 2, N, G>& others) {
  AllRows<T, N, G> m;
  m.template topRows<2>() = odd;
  m.template bottomRows<OneStick<N, G>::rows - 2>() = others;
  return m;
}

template <int N, Datum G, class T, class S>
AllRows<T, N, G> rows_at(const OneStickData<S>& data, const Eigen::Matrix<T, N, 1>& x) {
  const OneStickData<T> d = lifted<T>(data);
  return stacked<N, G, T>(odd_rows<N, G, T>(d, x), other_rows<N, G, T>(d, x));
}

// What is left of combined rows; nothing where a pivot may vanish.
template <int N, Datum G, class T>
std::optional<LoadRows<T, N, G>> left_for_load(AllRows<T, N, G> m) {
  using Problem = OneStick<N, G>;
  if (!zeros::eliminate<T, Problem::rows, Problem::columns>(m, 0, amplitudes)) {
    return std::nullopt;
  }
  return LoadRows<T, N, G>(m.template bottomRightCorner<Problem::left, Problem::loads>());
}

template <class T>
T det2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}

template <int N, class T>
Eigen::Matrix<T, 3, 1> direction(const LoadRows<T, N, Datum::friction>& m, int i, int j) {
  const auto minor = [&](int k, int l) { return det2<T>(m(i, k), m(i, l), m(j, k), m(j, l)); };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class T>
T circle(const Eigen::Matrix<T, 3, 1>& n) {
  return n(0) * n(0) + n(1) * n(1) - n(2) * n(2);
}

// What must vanish.
template <int N, Datum G, class T>
Eigen::Matrix<T, N, 1> functions(const LoadRows<T, N, G>& m) {
  if constexpr (G == Datum::phase) {
    return m;
  } else {
    const Eigen::Matrix<T, 3, 1> n = direction<N, T>(m, 0, 1);
    Eigen::Matrix<T, N, 1> f;
    f(0) = circle<T>(n);
    if constexpr (N == 2) {
      f(1) = m(2, 0) * n(0) + m(2, 1) * n(1) + m(2, 2) * n(2);
    }
    return f;
  }
}

}  // namespace stickslip::numeric::families
