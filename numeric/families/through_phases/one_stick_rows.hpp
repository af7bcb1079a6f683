// The rows of one_stick_closing.hpp: for source files.
#pragma once

#include <array>

#include "model/slip_again.hpp"
#include "numeric/families/through_phases/linear_closing_search.hpp"
#include "numeric/families/through_phases/one_stick_closing.hpp"

namespace stickslip::numeric::families {

template <class T, class S>
OneStickData<T> lifted(const OneStickData<S>& data) {
  return {model::lift<T>(data.d), T(data.given)};
}

// tau and tau1 for the halves of a motion: of three phases tau is all of them.
template <class T, int N>
std::pair<T, T> both_times(const Eigen::Matrix<T, N, 1>& t) {
  if constexpr (N == 3) {
    return {T(t(0) + t(1) + t(2)), T(0)};
  } else {
    return {t(0), N == 2 ? t(N - 1) : T(0)};
  }
}

template <int N, Datum G, class T, std::size_t R>
Eigen::Matrix<T, static_cast<int>(R), OneStick<N, G>::columns> as_matrix(
    const OneStickData<T>& data, const T& total, const std::array<model::OvershootingRow<T>, R>& all) {
  Eigen::Matrix<T, static_cast<int>(R), OneStick<N, G>::columns> m;
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

// The data for the rows of a motion's halves: with one time the friction does not turn, and with three
// add_overshoot turns it.
template <class T, int N>
model::ReducedData<T> of_halves(const model::ReducedData<T>& d) {
  model::ReducedData<T> result = d;
  if (N != 2) {
    result.us = T(0);
  }
  return result;
}

template <class T>
model::SlipTimes<T> slip_times(const Eigen::Matrix<T, 3, 1>& t) {
  return {t(0), t(1), t(2)};
}

// odd_1 and odd_2: their columns a, D and cos psi are zero.
template <int N, Datum G, class T>
FirstRows<OneStick<N, G>, T> odd_rows(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  const Eigen::Matrix<T, N, 1> t = times<T, N>(data.d.Theta, x);
  const auto [tau, tau1] = both_times<T, N>(t);
  auto odd = model::overshooting_odd<T>(of_halves<T, N>(data.d), tau, tau1);
  if constexpr (N == 3) {
    std::array<model::OvershootingRow<T>, 2> even;
    model::add_overshoot<T>(data.d, slip_times<T>(t), odd, even);
  }
  return as_matrix<N, G>(data, T(tau + tau1), odd);
}

// even_1, even_2, with more than one time the turns, and where ur is given (12).
template <int N, Datum G, class T>
OtherRows<OneStick<N, G>, T> even_rows(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  const Eigen::Matrix<T, N, 1> t = times<T, N>(data.d.Theta, x);
  const auto [tau, tau1] = both_times<T, N>(t);
  auto even = model::overshooting_even<T>(of_halves<T, N>(data.d), tau, tau1);
  std::array<model::OvershootingRow<T>, OneStick<N, G>::rows - 2> all;
  if constexpr (N == 2) {
    all[2] = model::overshooting_turn<T>(data.d, tau, tau1);
  }
  if constexpr (N == 3) {
    std::array<model::OvershootingRow<T>, 2> odd;
    model::add_overshoot<T>(data.d, slip_times<T>(t), odd, even);
    const auto turns = model::slip_again_turns<T>(data.d, slip_times<T>(t), T(T(data.d.Theta - tau) / T(2)));
    all[2] = turns[0];
    all[3] = turns[1];
  }
  all[0] = even[0];
  all[1] = even[1];
  if constexpr (G == Datum::friction) {
    all.back() = model::overshooting_friction<T>(data.d, data.given, tau, tau1);
  }
  return as_matrix<N, G>(data, T(tau + tau1), all);
}

template <int N, Datum G, class T>
AllRows<OneStick<N, G>, T> rows_of(const OneStickData<T>& data, const Eigen::Matrix<T, N, 1>& x) {
  return stacked<OneStick<N, G>, T>(odd_rows<N, G, T>(data, x), even_rows<N, G, T>(data, x));
}

}  // namespace stickslip::numeric::families
