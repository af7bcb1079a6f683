// The closing conditions of one slip and one stick over n periods of the load at a given friction, as rows
// that are linear in (z10, z20, z10', cos phi, sin phi, 1), the state and the load's phase when the slip
// begins; the duration tau of the slip is what remains.
//
// With the stick taken backwards, Gamma(-T), T = n Theta - tau, the state after the slip (5) is
//   H(tau) (Z0 - F0) + F(tau) = Gamma(-T) Z0:     rows z1, z2, z1';
//   z2'(tau) = V, divided by tau, for at tau = 0 it says nothing:  (z2'(tau) - z2'(0))/tau = 0;
//   r = ur at the beginning of the slip (12):      chi (z20 - z10) + us - ur - (p/eta) cos phi = 0.
// With the three columns of the state eliminated two rows (a, b, c), (a', b', c') of cos phi, sin phi and 1
// remain. Their vector product n is parallel to (cos phi, sin phi, 1), so with n3 ≠ 0 there is a closed
// motion exactly if n1² + n2² = n3².
#pragma once

#include "model/flows.hpp"
#include "model/lift.hpp"
#include "model/sinc.hpp"
#include "model/waves.hpp"

namespace stickslip::numeric::words {

inline constexpr int stick_slip_rows = 5;
inline constexpr int stick_slip_columns = 6;

template <class T>
using StickSlipRows = Eigen::Matrix<T, stick_slip_rows, stick_slip_columns>;

template <class T, class S>
[[nodiscard]] StickSlipRows<T> rows_of_stick_slip(const model::Oscillator<S>& oscillator, const S& ur,
                                                  const S& total, const T& tau) {
  const model::Modes<T> m = model::lift<T>(oscillator.modes);
  const model::Parameters<T> a = model::lift<T>(oscillator.data);
  const T q1 = T(oscillator.Q(0));
  const T q2 = T(oscillator.Q(1));
  const model::Matrix4<T> H = model::H<T>(m, tau);
  const model::Matrix4<T> G = model::Gamma<T>(a.chi, T(tau - T(total)));
  const std::pair<T, T> turn = sin_cos(T(a.omega * tau));
  const T& s = turn.first;
  const T& c = turn.second;
  StickSlipRows<T> rows;
  // z1, z2, z1': F0 = (Q cos phi, -omega Q sin phi), F(tau) the same at phi + omega tau.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      rows(i, j) = H(i, j) - G(i, j);
    }
    const T& q = i == 1 ? q2 : q1;
    const bool rate = i == 2;
    const T from_cos = rate ? T(-a.omega * q * s) : T(q * c);
    const T from_sin = rate ? T(-a.omega * q * c) : T(-(q * s));
    rows(i, 3) = from_cos - H(i, 0) * q1 - H(i, 1) * q2;
    rows(i, 4) = from_sin + a.omega * (H(i, 2) * q1 + H(i, 3) * q2);
    rows(i, 5) = (H(i, 3) - G(i, 3)) * a.V;
  }
  // The mean acceleration: of a mode, (sin(w tau)/tau) and (cos(w tau) - 1)/tau.
  const auto sine = [&](const T& w) { return T(w * T(sinc(T(w * tau)))); };
  const auto cosine = [&](const T& w) {
    const T half = T(sinc(T(w * tau / T(2))));
    return T(-(w * w * tau / T(2)) * half * half);
  };
  const T det = m.lambda2 - m.lambda1;
  const T g1 = -m.lambda1 * m.omega1 * sine(m.omega1) / det;
  const T g2 = -m.lambda2 * m.omega2 * sine(m.omega2) / det;
  const T k1 = m.lambda1 * cosine(m.omega1) / det;
  const T k2 = m.lambda2 * cosine(m.omega2) / det;
  // y1 = (lambda2 z1 - z2)/det, y2 = (z2 - lambda1 z1)/det, of z - Q cos phi and of z' + omega Q sin phi.
  const T of_z1 = g1 * m.lambda2 - g2 * m.lambda1;
  const T of_z2 = g2 - g1;
  const T of_rate1 = k1 * m.lambda2 - k2 * m.lambda1;
  const T of_rate2 = k2 - k1;
  rows(3, 0) = of_z1;
  rows(3, 1) = of_z2;
  rows(3, 2) = of_rate1;
  rows(3, 3) = -(of_z1 * q1) - of_z2 * q2 - a.omega * q2 * sine(a.omega);
  rows(3, 4) = a.omega * (of_rate1 * q1 + of_rate2 * q2 - q2 * cosine(a.omega));
  rows(3, 5) = of_rate2 * a.V;
  rows(4, 0) = -a.chi;
  rows(4, 1) = a.chi;
  rows(4, 2) = T(0);
  rows(4, 3) = -(a.p / a.eta);
  rows(4, 4) = T(0);
  rows(4, 5) = a.us - T(ur);
  return rows;
}

}  // namespace stickslip::numeric::words
