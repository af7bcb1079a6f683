// Motions of a slip, an overshoot, a slip and a stick that close: the rows of overshooting_closing.hpp with a
// turn of the friction more, for durations t0, t1, t2 and the rest T of Theta.
//
// Each mode obeys y_j'' + omega_j² y_j = -f with f = p cos(omega s + psi), less 2 eta us on the overshoot, s
// the time from the middle of the slips and the overshoot together, of the duration t. Multiplied by
// sin(omega_j s) and by cos(omega_j s) and integrated from end to end it gives odd_j and even_j, in which the
// friction has the parts
//   odd_j: -2 eta us/omega_j sin(omega_j m) sin(omega_j t1/2),   even_j: the same with cos(omega_j m),
// m = (t0 - t2)/2 the middle of the overshoot. z2' = V where the overshoot begins and ends: the mean
// accelerations F0, F1, F2 of mass 2 on the three phases have t0 F0 + t1 F1 + t2 F2 = 0, for z2' = V at both
// ends of the stick; so for positive durations these two say the same as
//   F0 - F1 = 0,  F2 - F1 = 0,
// which say more where a phase lasts no time. With k = omega_j h/2, h the duration of a phase, y0 and y0' of
// its beginning, theta the load's phase at its middle and c the friction's part of f, mode j has on it the
// mean acceleration
//   -omega_j sinc(k) (omega_j y0 cos k + y0' sin k) - c sinc(2 k)
//     - p/2 (cos(k + theta) sinc((omega - omega_j) h/2) + cos(k - theta) sinc((omega + omega_j) h/2)).
// F0 takes y0 from the end of the stick; F2 is that of the motion run backwards from the stick's beginning;
// F1 takes the motion from the end of the stick on through f on the first slip, of which it sees, b = omega_j
// (t0 + t1)/2,
//   omega_j sinc(k) p t0/2 (sin(b + theta0) sinc((omega - omega_j) t0/2)
//                           + sin(b - theta0) sinc((omega + omega_j) t0/2)).
#pragma once

#include "model/overshooting_closing.hpp"

namespace stickslip::model {

template <class S>
using SlipTimes = std::array<S, 3>;

namespace detail {

// factor cos(beta + psi), as a row.
template <class S>
void add_cos(OvershootingRow<S>& row, const S& factor, const S& beta) {
  const std::pair<S, S> at = sin_cos(beta);
  row.cos_psi += factor * at.second;
  row.sin_psi -= factor * at.first;
}
template <class S>
void add_sin(OvershootingRow<S>& row, const S& factor, const S& beta) {
  const std::pair<S, S> at = sin_cos(beta);
  row.cos_psi += factor * at.first;
  row.sin_psi += factor * at.second;
}

template <class S>
void add(OvershootingRow<S>& sum, const S& factor, const OvershootingRow<S>& row) {
  sum.a += factor * row.a;
  sum.C += factor * row.C;
  sum.D += factor * row.D;
  sum.cos_psi += factor * row.cos_psi;
  sum.sin_psi += factor * row.sin_psi;
  sum.one += factor * row.one;
}

// A mode of the motion beside the stick, seen away from it.
template <class S>
struct Beside {
  OvershootingRow<S> y, rate;
};

// direction: 1 where the stick ends, -1 where it begins.
template <class S>
[[nodiscard]] Beside<S> beside(const ReducedData<S>& d, const S& omega_k, const S& lambda_k, const S& half_T,
                               int direction) {
  const std::pair<S, S> stick = sin_cos(half_T);
  const S square = omega_k * omega_k;
  const S way(direction);
  Beside<S> r;
  r.y.a = -square;
  r.y.C = way * lambda_k * stick.first;
  r.y.D = lambda_k * stick.second;
  r.y.one = -way * square * d.V * half_T;
  r.rate.C = way * lambda_k * stick.second;
  r.rate.D = -lambda_k * stick.first;
  r.rate.one = -way * square * d.V;
  return r;
}

// Of a phase of the duration h; the load's phase at its middle is psi + delta.
template <class S>
[[nodiscard]] OvershootingRow<S> mean_acceleration_row(const Beside<S>& from, const S& omega_j,
                                                       const ReducedData<S>& d, const S& h, const S& delta) {
  const S k = omega_j * h / S(2);
  const std::pair<S, S> at_k = sin_cos(k);
  const S factor = -omega_j * S(sinc(k));
  OvershootingRow<S> row;
  add(row, S(factor * omega_j * at_k.second), from.y);
  add(row, S(factor * at_k.first), from.rate);
  const S half_p = -d.p / S(2);
  add_cos(row, S(half_p * S(sinc(S((d.omega - omega_j) * h / S(2))))), S(k + delta));
  add_cos(row, S(half_p * S(sinc(S((d.omega + omega_j) * h / S(2))))), S(delta - k));
  return row;
}

}  // namespace detail

// The friction's part of odd_j and even_j, for rows whose friction does not turn.
template <class S>
void add_overshoot(const ReducedData<S>& d, const SlipTimes<S>& t, std::array<OvershootingRow<S>, 2>& odd,
                   std::array<OvershootingRow<S>, 2>& even) {
  const std::array<S, 2> omega{d.m.omega1, d.m.omega2};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::pair<S, S> middle = sin_cos(S(omega[j] * S(t[0] - t[2]) / S(2)));
    const S force = d.eta * d.us * t[1] * S(sinc(S(omega[j] * t[1] / S(2))));
    odd[j].one -= force * middle.first;
    even[j].one -= force * middle.second;
  }
}

// F0 - F1 and F2 - F1, multiplied by lambda_2 - lambda_1; half_T is T/2.
template <class S>
[[nodiscard]] std::array<OvershootingRow<S>, 2> slip_again_turns(const ReducedData<S>& d,
                                                                 const SlipTimes<S>& t, const S& half_T) {
  using namespace detail;
  std::array<OvershootingRow<S>, 2> rows;
  const auto mode = [&](const S& omega_j, const S& omega_k, const S& lambda_k, const S& weight) {
    const Beside<S> after = beside<S>(d, omega_k, lambda_k, half_T, 1);
    const Beside<S> before = beside<S>(d, omega_k, lambda_k, half_T, -1);
    const S delta0 = -d.omega * S(t[1] + t[2]) / S(2);
    add(rows[0], weight, mean_acceleration_row<S>(after, omega_j, d, t[0], delta0));
    // Backwards the load's phase is minus what it is: cos(beta - psi) has the other sign at sin psi.
    OvershootingRow<S> last =
        mean_acceleration_row<S>(before, omega_j, d, t[2], S(-d.omega * S(t[0] + t[1]) / S(2)));
    last.sin_psi = -last.sin_psi;
    add(rows[1], weight, last);
    // F1: the middle of the overshoot is b/omega_j after the middle of the first slip.
    const S k = omega_j * t[1] / S(2);
    const S seen = omega_j * S(sinc(k));
    const std::pair<S, S> at_middle = sin_cos(S(omega_j * S(t[0] + t[1] / S(2))));
    OvershootingRow<S> over;
    add(over, S(-seen * omega_j * at_middle.second), after.y);
    add(over, S(-seen * at_middle.first), after.rate);
    over.one += S(2) * d.eta * d.us * S(sinc(S(S(2) * k)));
    const S b = omega_j * S(t[0] + t[1]) / S(2);
    const S past = seen * d.p * t[0] / S(2);
    add_sin(over, S(past * S(sinc(S((d.omega - omega_j) * t[0] / S(2))))), S(b + delta0));
    add_sin(over, S(-past * S(sinc(S((d.omega + omega_j) * t[0] / S(2))))), S(delta0 - b));
    const S delta = d.omega * S(t[0] - t[2]) / S(2);
    const S half_p = -d.p / S(2);
    add_cos(over, S(half_p * S(sinc(S((d.omega - omega_j) * t[1] / S(2))))), S(k + delta));
    add_cos(over, S(half_p * S(sinc(S((d.omega + omega_j) * t[1] / S(2))))), S(delta - k));
    add(rows[0], S(-weight), over);
    add(rows[1], S(-weight), over);
  };
  mode(d.m.omega1, d.m.omega2, d.m.lambda2, d.m.lambda1);
  mode(d.m.omega2, d.m.omega1, d.m.lambda1, S(-d.m.lambda2));
  return rows;
}

}  // namespace stickslip::model
