// The closing conditions of Section 5, reduced by hand to five equations in (tau, tau1) and three amplitudes
// (a, C, D) of the stick; linear in the amplitudes and in (cos psi, sin psi), where psi = phi + omega (tau +
// tau1)/2 is the load's phase at the middle of the two slips.
//
// Derivation. On the stick, s the time from its middle, z2 = a + V s and z1 = chi z2 + C sin s + D cos s. So
// with T = Theta - tau - tau1 the state at the beginning of the slip, s = T/2, is
//   z20 = a + V T/2,  z10 = chi z20 + C sin(T/2) + D cos(T/2),  zdot10 = chi V + C cos(T/2) - D sin(T/2),
// zdot20 = V, and the state Z_C at its end, s = -T/2, is the same with the signs of V T/2, C sin and D sin
// turned. These are all states with z2' = V at both ends that (10) joins: Z(Theta) = Z0 and z2C' = V hold by
// construction. The slip and the overshoot take Z0 to Z_C if and only if in each mode, z = Lambda y,
//   y_j(s) = A_j cos(omega_j s) + B_j sin(omega_j s) + Qh_j cos(omega s + psi)
//            - 2 delta_j (1 - cos(omega_j (s - s_tau))) [s > s_tau],        d0 = Lambda delta,
// for some A_j, B_j, s now the time from the middle of (0, tau + tau1). Eliminating B_j from the odd part of
// (y, y') at the ends and A_j from the even part (always possible: cos alpha_j and sin alpha_j are not both
// 0) gives, with alpha_j = omega_j (tau + tau1)/2, mu_j = omega_j tau/2, nu_j = omega_j tau1/2,
//   odd_j:   C lambda_k P_j - V omega_k² R_j - p sin(psi) S_j - 2 eta us/omega_j sin(mu_j) sin(nu_j) = 0
//   even_j: -a omega_k² omega_j sin(alpha_j) + D lambda_k P'_j - p cos(psi) S'_j
//                                                          - 2 eta us/omega_j cos(mu_j) sin(nu_j) = 0
// with P_j, R_j, S_j of symmetric.hpp at tau + tau1 and
//   P'_j = omega_j sin(alpha_j) cos(T/2) + cos(alpha_j) sin(T/2),
//   S'_j = (omega sin(beta) cos(alpha_j) - omega_j cos(beta) sin(alpha_j))/(omega_j² - omega²).
// There remains z2'(tau) = V. The mean accelerations F = (z2'(0) - z2'(tau))/tau and
// G = (z2'(tau) - z2'(tau + tau1))/tau1 are entire in tau, tau1; z2'(0) = z2C' = V gives tau F + tau1 G = 0,
// so F - G = (tau + tau1) F/tau1 = -(tau + tau1) G/tau and for tau, tau1 > 0
//   turn:  F - G = 0   if and only if   z2'(tau) = V.
// On the edges tau1 = 0 and tau = 0 the equation z2'(tau) = V says nothing and its place is taken by its
// limit: z2'' = 0 there. Nothing is divided by a quantity that can vanish for tau + tau1 > 0.
#pragma once

#include "model/symmetric.hpp"

namespace stickslip::model {

// One equation a·x + C·y + … = 0 by its coefficients.
template <class S>
struct OvershootingRow {
  S a = S(0);
  S C = S(0);
  S D = S(0);
  S cos_psi = S(0);
  S sin_psi = S(0);
  S one = S(0);
};

// odd_1 and odd_2. Their columns a, D and cos psi are zero.
template <class S>
[[nodiscard]] std::array<OvershootingRow<S>, 2> overshooting_odd(const ReducedData<S>& d, const S& tau,
                                                                 const S& tau1) {
  using std::cos;
  const S total = tau + tau1;
  const S half_T = (d.Theta - total) / S(2);
  const auto row = [&](const S& omega_j, const S& omega_k, const S& lambda_k) {
    const S alpha = omega_j * total / S(2);
    const std::pair<S, S> whole = sin_cos(alpha);
    const S& sin_alpha = whole.first;
    const S& cos_alpha = whole.second;
    const S c = omega_j * cos_alpha;
    OvershootingRow<S> r;
    r.C = lambda_k * stick_transfer<S>(omega_j, d.Theta, total).odd;
    r.sin_psi = -d.p * load_transfer<S>(omega_j, d.omega, total);
    // 2 sin(mu) sin(nu) = cos(mu - nu) - cos(alpha)
    r.one = -d.V * omega_k * omega_k * S(c * half_T + sin_alpha) -
            d.eta * d.us / omega_j * S(S(cos(S(omega_j * (tau - tau1) / S(2)))) - cos_alpha);
    return r;
  };
  return {row(d.m.omega1, d.m.omega2, d.m.lambda2), row(d.m.omega2, d.m.omega1, d.m.lambda1)};
}

// even_1 and even_2. Their columns C and sin psi are zero.
template <class S>
[[nodiscard]] std::array<OvershootingRow<S>, 2> overshooting_even(const ReducedData<S>& d, const S& tau,
                                                                  const S& tau1) {
  using std::sin;
  const S total = tau + tau1;
  const auto row = [&](const S& omega_j, const S& omega_k, const S& lambda_k) {
    const S sin_alpha = S(sin(S(omega_j * total / S(2))));
    OvershootingRow<S> r;
    r.a = -omega_k * omega_k * omega_j * sin_alpha;
    r.D = lambda_k * stick_transfer<S>(omega_j, d.Theta, total).even;
    // -S'_j = (tau + tau1)/4 (sinc((omega_j + omega)(tau + tau1)/2) + sinc((omega_j - omega)(tau + tau1)/2))
    const S half = total / S(2);
    r.cos_psi = d.p * half / S(2) *
                S(S(sinc(S((omega_j + d.omega) * half))) + S(sinc(S((omega_j - d.omega) * half))));
    // 2 cos(mu) sin(nu) = sin(alpha) - sin(mu - nu)
    r.one = -d.eta * d.us / omega_j * S(sin_alpha - S(sin(S(omega_j * (tau - tau1) / S(2)))));
    return r;
  };
  return {row(d.m.omega1, d.m.omega2, d.m.lambda2), row(d.m.omega2, d.m.omega1, d.m.lambda1)};
}

// One phase's share of F or G in one mode: the mean acceleration of y_j over a duration t that begins (or, in
// the overshoot, seen backwards, ends) beside the stick. mu = omega_j t/2.
template <class S>
struct MeanAcceleration {
  S of_position;  // omega_j² sinc(2 mu): of y_j at the end beside the stick, from its rest
  S of_odd;       // omega_j sinc(mu) (omega_j cos(mu) sin(T/2) + sin(mu) cos(T/2)): of C h_j
  S of_even;      // omega_j sinc(mu) (omega_j cos(mu) cos(T/2) - sin(mu) sin(T/2)): of D h_j
  S of_belt;      // omega_j sinc(mu) (omega_j cos(mu) T/2 + sin(mu)): of V g_j
  S of_cos;       // -(2/t) cos(mu) S'_j(t): of p h'_j cos(load's phase at the phase's middle)
  S of_sin;       // (2/t) sin(mu) S_j(t): of p h'_j sin(…), its sign that of the direction of time
};

template <class S>
[[nodiscard]] MeanAcceleration<S> mean_acceleration(const S& omega_j, const S& omega, const S& half_T,
                                                    const S& t) {
  const S mu = omega_j * t / S(2);
  const S b = omega * t / S(2);
  const std::pair<S, S> at_mu = sin_cos(mu);
  const std::pair<S, S> sum = sin_cos(S(mu + half_T));
  const std::pair<S, S> difference = sin_cos(S(mu - half_T));
  const S above = (omega_j + S(1)) / S(2);
  const S below = (omega_j - S(1)) / S(2);
  const S factor = omega_j * S(sinc(mu));
  const S near = S(sinc(S(mu - b)));
  const S far = S(sinc(S(mu + b)));
  return {S(omega_j * omega_j * S(sinc(S(S(2) * mu)))),
          S(factor * S(above * sum.first - below * difference.first)),
          S(factor * S(above * sum.second + below * difference.second)),
          S(factor * S(omega_j * at_mu.second * half_T + at_mu.first)),
          S(at_mu.second * S(near + far) / S(2)),
          S(at_mu.first * S(near - far) / S(2))};
}

// turn, multiplied by lambda_2 - lambda_1.
template <class S>
[[nodiscard]] OvershootingRow<S> overshooting_turn(const ReducedData<S>& d, const S& tau, const S& tau1) {
  const S half_T = (d.Theta - tau - tau1) / S(2);
  const S b = d.omega * tau / S(2);
  const S b1 = d.omega * tau1 / S(2);
  const std::pair<S, S> at_b = sin_cos(b);
  const std::pair<S, S> at_b1 = sin_cos(b1);
  const S& sin_b = at_b.first;
  const S& cos_b = at_b.second;
  const S& sin_b1 = at_b1.first;
  const S& cos_b1 = at_b1.second;
  OvershootingRow<S> r;
  // h, g and load: the mode's shares of (1, 0), (chi, 1) and (0, 1) in z2, times lambda_2 - lambda_1.
  const auto add = [&](const S& omega_j, const S& h, const S& g, const S& load) {
    const MeanAcceleration<S> slip = mean_acceleration<S>(omega_j, d.omega, half_T, tau);
    const MeanAcceleration<S> over = mean_acceleration<S>(omega_j, d.omega, half_T, tau1);
    r.a += g * S(slip.of_position - over.of_position);
    r.C += h * S(slip.of_odd + over.of_odd);
    r.D += h * S(slip.of_even - over.of_even);
    // The middle of the slip is at the load's phase psi - b1, that of the overshoot at psi + b.
    r.cos_psi += d.p * load *
                 S(over.of_cos * cos_b + over.of_sin * sin_b - slip.of_cos * cos_b1 - slip.of_sin * sin_b1);
    r.sin_psi += d.p * load *
                 S(over.of_sin * cos_b - over.of_cos * sin_b - slip.of_cos * sin_b1 + slip.of_sin * cos_b1);
    r.one +=
        d.V * g * S(slip.of_belt + over.of_belt) - S(2) * d.eta * d.us * load * S(sinc(S(omega_j * tau1)));
  };
  const S& l1 = d.m.lambda1;
  const S& l2 = d.m.lambda2;
  add(d.m.omega1, S(l1 * l2), S(-l1 * d.m.omega2 * d.m.omega2), S(-l1));
  add(d.m.omega2, S(-l1 * l2), S(l2 * d.m.omega1 * d.m.omega1), l2);
  return r;
}

// (12), (24): chi (z20 - z10) - p/eta cos(phi) + us - ur = 0, phi = psi - omega (tau + tau1)/2.
template <class S>
[[nodiscard]] OvershootingRow<S> overshooting_friction(const ReducedData<S>& d, const S& ur, const S& tau,
                                                       const S& tau1) {
  const std::pair<S, S> stick = sin_cos(S((d.Theta - tau - tau1) / S(2)));
  const std::pair<S, S> load = sin_cos(S(d.omega * S(tau + tau1) / S(2)));
  const S stiffness = d.chi * S(S(1) - d.chi);
  OvershootingRow<S> r;
  r.a = stiffness;
  r.C = -d.chi * stick.first;
  r.D = -d.chi * stick.second;
  r.cos_psi = -d.p / d.eta * load.second;
  r.sin_psi = -d.p / d.eta * load.first;
  r.one = stiffness * d.V * (d.Theta - tau - tau1) / S(2) + d.us - ur;
  return r;
}

// The state Z0 at the beginning of the slip.
template <class S>
[[nodiscard]] Vector4<S> overshooting_start(const ReducedData<S>& d, const S& T, const S& a, const S& C,
                                            const S& D) {
  const S half_T = T / S(2);
  const std::pair<S, S> stick = sin_cos(half_T);
  const S& sin_T = stick.first;
  const S& cos_T = stick.second;
  Vector4<S> Z0;
  Z0(1) = a + d.V * half_T;
  Z0(0) = d.chi * Z0(1) + C * sin_T + D * cos_T;
  Z0(2) = d.chi * d.V + C * cos_T - D * sin_T;
  Z0(3) = d.V;
  return Z0;
}

}  // namespace stickslip::model
