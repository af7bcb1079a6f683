// The symmetric orbit of Section 4: slip on (0, tau), stick on (tau, Theta).
#pragma once

#include "model/flows.hpp"
#include "model/parameters.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::model {

// (16): its four scalar equations for (tau, z10, z20, zdot10), with z2'(0) = V and T = Theta - tau.
// s0 = sin(omega tau/2), c0 = cos(omega tau/2). Rows 1, 2: (H_1 + I)(z0 - Q s0) + H_2 (z0' + Q omega c0),
// blocks at tau; rows 3, 4: (Gamma_1 + I) z0 - Gamma_2 z0', blocks at T.
template <class S>
[[nodiscard]] Vector4<S> symmetric_residual(const S& chi, const Modes<S>& m, const Vector2<S>& Q,
                                            const S& omega, const S& Theta, const S& tau,
                                            const Vector2<S>& z0, const Vector2<S>& zdot0) {
  using std::cos;
  using std::sin;
  const S half = omega * tau / S(2);
  const S s0 = S(sin(half));
  const S c0 = S(cos(half));
  const Blocks<S> h = H_blocks(m, tau);
  const Blocks<S> g = Gamma_blocks<S>(chi, S(Theta - tau));
  const Vector2<S> slip =
      (h.first + identity2<S>()) * Vector2<S>(z0 - Q * s0) + h.second * Vector2<S>(zdot0 + Q * S(omega * c0));
  const Vector2<S> stick = (g.first + identity2<S>()) * z0 - g.second * zdot0;
  return stack<S>(slip, stick);
}

// The closing conditions (13) and (15) of the symmetric orbit, reduced by hand to two equations in two
// unknowns (tau, C) that have its orbits as zeros, no more and no less.
//
// Derivation. Write z = Lambda y, psi0 the load's phase at the middle of the slip, s the time from there, and
// alpha_j = omega_j tau/2, beta = omega tau/2. In each mode
//   y_j(s) = A_j cos(omega_j s) + B_j sin(omega_j s) + Qh_j cos(omega s + psi0),      Q = Lambda Qh,
// and (13), Z(tau) = E Z(0), says that the part of y_j even in s vanishes with its derivative at s = ±tau/2:
//   A_j cos alpha_j + Qh_j cos(psi0) cos beta = 0,   A_j omega_j sin alpha_j + Qh_j omega cos(psi0) sin beta
//   = 0.
// With cos(psi0) = 0, that is phi = (pi - omega tau)/2 (sigma = +1) or that plus pi (sigma = -1), this is
// A_j = 0: the motion is odd about the middle of the slip. [If cos(psi0) ≠ 0 and p ≠ 0 it asks for
// omega_j sin(alpha_j) cos(beta) = omega sin(beta) cos(alpha_j) for both j at one tau.]
// (15), with z2' = V on the stick, says in the same way that the stick is odd about its own middle:
//   z2 = V s,  z1 = chi V s + C sin s,  s in (-T/2, T/2).
// So the state at the beginning of the slip, s = T/2 of the stick, is
//   z20 = V T/2,  z10 = chi V T/2 + C sin(T/2),  zdot10 = chi V + C cos(T/2),  zdot20 = V,
// and it is a state of the slip with some B_j if and only if, for j = 1, 2,
//   omega_j cos(alpha_j) (y_j0 - sigma Qh_j sin beta) + sin(alpha_j) (ydot_j0 + sigma Qh_j omega cos beta) =
//   0.
// With Lambda⁻¹ multiplied by lambda_2 - lambda_1 (never 0) and Qh_j (omega_j² - omega²) = ∓p these are
//   C lambda_k P_j = V omega_k² R_j + sigma p S_j,   (j, k) = (1, 2), (2, 1),
//   P_j = omega_j cos(alpha_j) sin(T/2) + sin(alpha_j) cos(T/2),
//   R_j = omega_j cos(alpha_j) T/2 + sin(alpha_j),
//   S_j = (omega cos(beta) sin(alpha_j) - omega_j sin(beta) cos(alpha_j)) / (omega_j² - omega²)
//       = tau/4 (sinc((omega_j - omega) tau/2) - sinc((omega_j + omega) tau/2)),
// regular also at the resonances omega = omega_j. No step divides by anything that can vanish: for every
// tau in [0, Theta] the two equations hold for some C if and only if all of (13) and (15) hold.

// The data of reduced equations, of these and those of overshooting_closing.hpp. They need no load amplitude
// vector Q.
template <class S>
struct ReducedData : Parameters<S> {
  Modes<S> m;
  S Theta;  // 2 pi/omega
};
template <class S>
[[nodiscard]] ReducedData<S> reduced_data(const Parameters<S>& a, const S& pi) {
  return {a, modes<S>(a.chi, a.eta), S(S(2) * pi / a.omega)};
}
template <class T, class S>
[[nodiscard]] ReducedData<T> lift(const ReducedData<S>& a) {
  return {lift<T>(static_cast<const Parameters<S>&>(a)), lift<T>(a.m), T(a.Theta)};
}

template <class S>
struct SymmetricData : ReducedData<S> {
  S sigma;  // +1: phi = (pi - omega tau)/2; -1: that plus pi
};

// Row j: C left(j) = right(j).
template <class S>
struct SymmetricRows {
  Vector2<S> left, right;
};

// S_j of the derivation.
template <class S>
[[nodiscard]] S load_transfer(const S& omega_j, const S& omega, const S& tau) {
  const S half = tau / S(2);
  return half / S(2) * S(sinc(S((omega_j - omega) * half)) - sinc(S((omega_j + omega) * half)));
}

// P_j, and P'_j of overshooting_closing.hpp, as sums of two sines: slips of total duration `total`, Theta the
// period. In these the argument changes slowly with `total`, so that enclosures are tight.
template <class S>
struct StickTransfer {
  S odd;   // omega_j cos(alpha_j) sin(T/2) + sin(alpha_j) cos(T/2)
  S even;  // omega_j sin(alpha_j) cos(T/2) + cos(alpha_j) sin(T/2)
};
template <class S>
[[nodiscard]] StickTransfer<S> stick_transfer(const S& omega_j, const S& Theta, const S& total) {
  using std::sin;
  const S above = omega_j + S(1);
  const S below = omega_j - S(1);
  const S sum = above * S(sin(S((Theta + below * total) / S(2))));         // sin(alpha_j + T/2)
  const S difference = below * S(sin(S((above * total - Theta) / S(2))));  // sin(alpha_j - T/2)
  return {S((sum - difference) / S(2)), S((sum + difference) / S(2))};
}

// lambda_k P_j and V omega_k² R_j + sigma p S_j, k the other mode.
template <class S>
[[nodiscard]] SymmetricRows<S> symmetric_rows(const SymmetricData<S>& a, const S& tau) {
  const S half_T = (a.Theta - tau) / S(2);
  const auto row = [&](const S& omega_j, const S& omega_k, const S& lambda_k, S& left, S& right) {
    const S alpha = omega_j * tau / S(2);
    const std::pair<S, S> at_alpha = sin_cos(alpha);
    const S c = omega_j * at_alpha.second;
    const S& s = at_alpha.first;
    left = lambda_k * stick_transfer<S>(omega_j, a.Theta, tau).odd;
    right =
        a.V * omega_k * omega_k * S(c * half_T + s) + a.sigma * a.p * load_transfer(omega_j, a.omega, tau);
  };
  SymmetricRows<S> rows;
  row(a.m.omega1, a.m.omega2, a.m.lambda2, rows.left(0), rows.right(0));
  row(a.m.omega2, a.m.omega1, a.m.lambda1, rows.left(1), rows.right(1));
  return rows;
}

// Both rows as residuals at (tau, C).
template <class S>
[[nodiscard]] Vector2<S> symmetric_closing(const SymmetricData<S>& a, const S& tau, const S& C) {
  const SymmetricRows<S> rows = symmetric_rows(a, tau);
  return rows.left * C - rows.right;
}

// C eliminated: one function of tau. It vanishes at every orbit, and elsewhere only where both left sides
// vanish together.
template <class S>
[[nodiscard]] S symmetric_eliminant(const SymmetricData<S>& a, const S& tau) {
  const SymmetricRows<S> rows = symmetric_rows(a, tau);
  return rows.left(1) * rows.right(0) - rows.left(0) * rows.right(1);
}

// The state Z0 at the beginning of the slip.
template <class S>
[[nodiscard]] Vector4<S> symmetric_start(const SymmetricData<S>& a, const S& tau, const S& C) {
  const S half_T = (a.Theta - tau) / S(2);
  Vector4<S> Z0;
  Z0(1) = a.V * half_T;
  const std::pair<S, S> stick = sin_cos(half_T);
  Z0(0) = a.chi * Z0(1) + C * stick.first;
  Z0(2) = a.chi * a.V + C * stick.second;
  Z0(3) = a.V;
  return Z0;
}

// The load's phase at the beginning of the slip, phi = (pi - omega tau)/2, plus pi when sigma = -1; half_turn
// is pi.
template <class S>
[[nodiscard]] S symmetric_phase(const SymmetricData<S>& a, const S& half_turn, const S& tau) {
  return half_turn * S(S(1) - a.sigma / S(2)) - a.omega * tau / S(2);
}

}  // namespace stickslip::model
