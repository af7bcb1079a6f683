// The closing conditions of one or two phases without stick and then a stick, over n periods of the load at a
// given friction, as rows that are linear in (z10, z20, z10', cos phi, sin phi, 1), the state and the load's
// phase when the first phase begins. How long the first phases last, tau and tau1, is what remains.
//
// With the stick taken backwards, Gamma(-T), T = n Theta - tau - tau1, and c1, c2 the rest positions in z of
// the phases, 0 for a slip and -2 d0 for an overshoot, (5) and (8) say of the state after them
//   H(tau + tau1) (Z0 - c1 - F0) + H(tau1) (c1 - c2) + c2 + F(tau + tau1) = Gamma(-T) Z0:  rows z1, z2, z1';
//   r = ur, or -ur before an overshoot, at the beginning (12):  chi (z20 - z10) + us ∓ ur - (p/eta) cos phi =
//   0; z2' = V where each of them ends, divided by how long it lasts, for after no time it says nothing:
//     (z2'(tau) - z2'(0))/tau = 0, (z2'(tau + tau1) - z2'(tau))/tau1 = 0.
// With the three columns of the state eliminated two or three rows (a, b, c) of cos phi, sin phi and 1
// remain.
#pragma once

#include "model/flows.hpp"
#include "model/lift.hpp"
#include "model/sinc.hpp"
#include "model/waves.hpp"

namespace stickslip::numeric::words {

// With N unknown times: z1, z2, z1', the friction, then an end for each time.
template <int N>
inline constexpr int closing_rows = 4 + N;
inline constexpr int closing_columns = 6;

template <class T, int N>
using ClosingRows = Eigen::Matrix<T, closing_rows<N>, closing_columns>;

// What the rows depend on besides the times.
template <class S>
struct ClosingData {
  model::Parameters<S> a;
  model::Modes<S> m;
  model::Vector2<S> Q, d0;
  S ur;
  S total;                   // n Theta
  bool begins_below = true;  // with a slip, else with an overshoot

  template <class T>
  [[nodiscard]] ClosingData<T> lifted() const {
    return {model::lift<T>(a), model::lift<T>(m), model::lift<T>(Q), model::lift<T>(d0), T(ur),
            T(total),          begins_below};
  }
};

namespace detail {

// (z2'(to) - z2'(from))/(to - from) of z2' = V at 0, in the flow (5) with its rest at c1, and of the flow
// that comes on top of it from `from` on because the rest is another by `jump` then.
template <class T>
[[nodiscard]] Eigen::Matrix<T, 1, closing_columns> mean_acceleration(const ClosingData<T>& d, const T& from,
                                                                     const T& length,
                                                                     const model::Vector2<T>& c1,
                                                                     const model::Vector2<T>& jump) {
  const model::Modes<T>& m = d.m;
  const T half = length / T(2);
  const T middle = from + half;
  // (sin(w to) - sin(w from))/length and the same of the cosine.
  const auto of = [&](const T& w) {
    const T mean = w * T(sinc(T(w * half)));
    const std::pair<T, T> at_middle = sin_cos(T(w * middle));
    return std::pair<T, T>(mean * at_middle.second, -(mean * at_middle.first));
  };
  const auto [sine1, cosine1] = of(m.omega1);
  const auto [sine2, cosine2] = of(m.omega2);
  const auto [sine, cosine] = of(d.a.omega);
  // y1 = (lambda2 z1 - z2)/det, y2 = (z2 - lambda1 z1)/det, of z - c1 - Q cos phi and of z' + omega Q sin
  // phi.
  const T scale = T(1) / (m.lambda2 - m.lambda1);
  const T g1 = -(m.lambda1 * m.omega1 * scale) * sine1;
  const T g2 = -(m.lambda2 * m.omega2 * scale) * sine2;
  const T k1 = m.lambda1 * scale * cosine1;
  const T k2 = m.lambda2 * scale * cosine2;
  const T of_z1 = g1 * m.lambda2 - g2 * m.lambda1;
  const T of_z2 = g2 - g1;
  const T of_rate1 = k1 * m.lambda2 - k2 * m.lambda1;
  const T of_rate2 = k2 - k1;
  Eigen::Matrix<T, 1, closing_columns> row;
  row(0) = of_z1;
  row(1) = of_z2;
  row(2) = of_rate1;
  row(3) = -(of_z1 * d.Q(0)) - of_z2 * d.Q(1) - d.a.omega * d.Q(1) * sine;
  row(4) = d.a.omega * (of_rate1 * d.Q(0) + of_rate2 * d.Q(1) - d.Q(1) * cosine);
  row(5) = of_rate2 * d.a.V - of_z1 * c1(0) - of_z2 * c1(1);
  if (!is_zero(jump(1))) {
    // Of a mode -omega_j sin(omega_j length)/length.
    const T first = m.lambda1 * m.omega1 * m.omega1 * scale * T(sinc(T(m.omega1 * length)));
    const T second = m.lambda2 * m.omega2 * m.omega2 * scale * T(sinc(T(m.omega2 * length)));
    row(5) -= first * (m.lambda2 * jump(0) - jump(1)) + second * (jump(1) - m.lambda1 * jump(0));
  }
  return row;
}

}  // namespace detail

// The times: tau, or tau and tau1.
template <class T, int N>
[[nodiscard]] ClosingRows<T, N> rows_of_closing(const ClosingData<T>& d,
                                                const Eigen::Matrix<T, N, 1>& times) {
  const T tau = times(0);
  const T tau1 = N == 2 ? times(N - 1) : T(0);
  const T sum = N == 2 ? T(tau + tau1) : tau;
  const model::Vector2<T> none(T(0), T(0));
  const model::Vector2<T> above(T(-2) * d.d0(0), T(-2) * d.d0(1));
  const model::Vector2<T>& c1 = d.begins_below ? none : above;
  const model::Vector2<T> jump = N == 1 ? none : d.begins_below ? model::Vector2<T>(-above) : above;
  const model::Blocks<T> h = model::H_blocks<T>(d.m, sum);
  const model::Blocks<T> g = model::Gamma_blocks<T>(d.a.chi, T(sum - d.total));
  const std::pair<T, T> turn = sin_cos(T(d.a.omega * sum));
  const model::Blocks<T> later = N == 2 ? model::H_blocks<T>(d.m, tau1) : h;
  ClosingRows<T, N> rows;
  for (int i = 0; i < 3; ++i) {
    const bool rate = i == 2;
    const int k = rate ? 0 : i;
    const model::Matrix2<T>& by_place = rate ? h.third : h.first;
    const model::Matrix2<T>& by_rate = rate ? h.first : h.second;
    const T s = turn.first;
    const T c = turn.second;
    const T q = d.Q(k);
    rows(i, 0) = by_place(k, 0) - (rate ? g.third : g.first)(k, 0);
    rows(i, 1) = by_place(k, 1) - (rate ? g.third : g.first)(k, 1);
    rows(i, 2) = by_rate(k, 0) - (rate ? g.first : g.second)(k, 0);
    rows(i, 3) =
        (rate ? T(-(d.a.omega * q * s)) : T(q * c)) - by_place(k, 0) * d.Q(0) - by_place(k, 1) * d.Q(1);
    rows(i, 4) = (rate ? T(-(d.a.omega * q * c)) : T(-(q * s))) +
                 d.a.omega * (by_rate(k, 0) * d.Q(0) + by_rate(k, 1) * d.Q(1));
    rows(i, 5) = (by_rate(k, 1) - (rate ? g.first : g.second)(k, 1)) * d.a.V;
    const T one = rate ? T(0) : T(1);
    for (int j = 0; j < 2; ++j) {
      if (!d.begins_below) {
        rows(i, 5) -= (by_place(k, j) - (j == k ? one : T(0))) * c1(j);
      }
      if (N == 2) {
        rows(i, 5) += ((rate ? later.third : later.first)(k, j) - (j == k ? one : T(0))) * jump(j);
      }
    }
  }
  rows(3, 0) = -d.a.chi;
  rows(3, 1) = d.a.chi;
  rows(3, 2) = T(0);
  rows(3, 3) = -(d.a.p / d.a.eta);
  rows(3, 4) = T(0);
  rows(3, 5) = d.begins_below ? T(d.a.us - d.ur) : T(d.a.us + d.ur);
  rows.row(4) = detail::mean_acceleration<T>(d, T(0), tau, c1, none);
  if (N == 2) {
    rows.row(3 + N) = detail::mean_acceleration<T>(d, tau, tau1, c1, jump);
  }
  return rows;
}

}  // namespace stickslip::numeric::words
