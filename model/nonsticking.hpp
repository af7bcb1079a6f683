// Periodic motions with two slip phases, below the belt on (0, tau) and above it on (tau, Theta): Section 6,
// and its extension to any tau and V.
//
// Off resonance (sin(omega_j pi/omega) ≠ 0, j = 1, 2) the friction u = us on (0, tau), -us on (tau, Theta)
// has exactly one response of period Theta. It is even about the middle of each phase, so its speed x2' is
// sigma at 0 and -sigma at tau. Each modal coordinate is c_j + a_j cos(omega_j (t - tau/2)) on the slip, c =
// Lambda⁻¹ d0, and matching at tau, with alpha_j = omega_j tau/2, beta_j = omega_j (Theta - tau)/2, gives
//   a_j = -2 c_j sin(beta_j)/sin(alpha_j + beta_j),
//   sigma = sum of lambda_j a_j omega_j sin(alpha_j).
// With the load's response Q cos(omega t + phi), delta = omega tau/2 and mu = phi + delta (the load's phase
// at the middle of the slip) the two remaining conditions x2'(0) = x2'(tau) = V read
//   sigma - q2 omega sin(mu - delta) = V,  -sigma - q2 omega sin(mu + delta) = V,
// and half their sum, and half their difference divided by sin(delta), are
//   V + q2 omega sin(mu) cos(delta) = 0,  sigma/sin(delta) + q2 omega cos(mu) = 0.            (two_slips)
// For 0 < delta < pi these two are equivalent to (28) with z2'(0) = z2'(tau) = V. Hence
//   tau = Theta/2 implies V = 0;  V = 0 implies tau = Theta/2 or sin(mu) = 0.
// In the latter case x2 is even about tau/2, so x2(tau) = x2(0), which x2' < V = 0 on (0, tau) excludes. For
// V ≠ 0 the same count, x2(tau) - x2(0) = (2 V/omega) tan(delta) against V tau and -V (Theta - tau), leaves
// pi/2 < delta < pi for V > 0 and 0 < delta < pi/2 for V < 0.
#pragma once

#include "model/flows.hpp"
#include "model/parameters.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::model {

// lambda_j c_j: what the friction us at mode j contributes to x2 at rest. c = Lambda⁻¹ d0.
template <class S>
[[nodiscard]] Vector2<S> modal_rest(const Modes<S>& m, const Vector2<S>& d0) {
  const S det = m.lambda2 - m.lambda1;
  return {S((m.lambda2 * d0(0) - d0(1)) / det), S((d0(1) - m.lambda1 * d0(0)) / det)};
}

// What the friction at mode j contributes to -sigma sin(omega_j pi/omega)/(2 pi sin(delta)), times
// (sinc(delta) + sinc(pi - delta)): entire in delta, for with sinc(alpha_j), sinc(beta_j) and sin(delta) =
// delta (pi - delta) (sinc(delta) + sinc(pi - delta))/pi the zeros at delta = 0 and pi are divided out.
template <class S>
[[nodiscard]] Vector2<S> friction_at_modes(const Modes<S>& m, const Vector2<S>& c, const S& omega,
                                           const S& pi, const S& delta) {
  const auto mode = [&](const S& omega_j, const S& lambda_j, const S& c_j) {
    const S ratio = omega_j / omega;
    return S(lambda_j * c_j * omega_j * ratio * ratio * S(sinc(S(ratio * delta))) *
             S(sinc(S(ratio * S(pi - delta)))));
  };
  return {mode(m.omega1, m.lambda1, c(0)), mode(m.omega2, m.lambda2, c(1))};
}

// sigma/sin(delta), entire in delta. Assumes no resonance.
template <class S>
[[nodiscard]] S friction_speed(const Modes<S>& m, const Vector2<S>& c, const S& omega, const S& pi,
                               const S& delta) {
  using std::sin;
  const Vector2<S> at = friction_at_modes<S>(m, c, omega, pi, delta);
  const S modes = at(0) / S(sin(S(m.omega1 / omega * pi))) + at(1) / S(sin(S(m.omega2 / omega * pi)));
  return S(-2) * pi * modes / (S(sinc(delta)) + S(sinc(S(pi - delta))));
}

// The left sides of (two_slips) at (delta, mu).
template <class S>
[[nodiscard]] Vector2<S> two_slips(const Parameters<S>& a, const Modes<S>& m, const S& q2,
                                   const Vector2<S>& c, const S& pi, const S& delta, const S& mu) {
  using std::cos;
  using std::sin;
  const S A = q2 * a.omega;
  return {S(a.V + A * S(sin(mu)) * S(cos(delta))),
          S(friction_speed<S>(m, c, a.omega, pi, delta) + A * S(cos(mu)))};
}

// The same, the first times D1 D2, D_j = omega² - omega_j², by which (7) is divided, and the second times
// sin(omega1 pi/omega) sin(omega2 pi/omega): these have no zero off resonance, and the products no pole at
// it. With e = (omega - omega_j) pi/omega
//   sin(omega_j pi/omega) = sin(e) = D_j pi sinc(e)/(omega (omega + omega_j)).
template <class S>
[[nodiscard]] Vector2<S> two_slips_without_poles(const Parameters<S>& a, const Modes<S>& m,
                                                 const Vector2<S>& c, const S& pi, const S& delta,
                                                 const S& mu) {
  using std::cos;
  using std::sin;
  const S& omega = a.omega;
  const S D1 = omega * omega - m.omega1 * m.omega1;
  const S D2 = omega * omega - m.omega2 * m.omega2;
  const S load = a.p * (S(1) - omega * omega) * omega;  // q2 omega D1 D2
  const auto sine_by_D = [&](const S& omega_j) {
    return S(pi * S(sinc(S((omega - omega_j) * pi / omega))) / (omega * (omega + omega_j)));
  };
  const S s1 = sine_by_D(m.omega1);
  const S s2 = sine_by_D(m.omega2);
  const Vector2<S> at = friction_at_modes<S>(m, c, omega, pi, delta);
  const S modes = at(0) * s2 * D2 + at(1) * s1 * D1;
  return {S(a.V * D1 * D2 + load * S(sin(mu)) * S(cos(delta))),
          S(S(-2) * pi * modes / (S(sinc(delta)) + S(sinc(S(pi - delta)))) + load * s1 * s2 * S(cos(mu)))};
}

// Z = (x - d0, x') at t = 0 and at t = tau of the periodic response to the friction and the load at (delta,
// mu): the friction's part is even about tau/2, the load's is Q cos(mu ∓ delta). x2' = V at both, by
// (two_slips).
template <class S>
struct TwoSlipsStates {
  Vector4<S> Z0, ZB;
};
template <class S>
[[nodiscard]] TwoSlipsStates<S> two_slips_states(const S& V, const Modes<S>& m, const Vector2<S>& Q,
                                                 const Vector2<S>& c, const S& omega, const S& pi,
                                                 const S& delta, const S& mu) {
  using std::cos;
  using std::sin;
  const auto amplitude = [&](const S& omega_j, const S& c_j) {
    return S(S(-2) * c_j * S(sin(S(omega_j / omega * (pi - delta)))) / S(sin(S(omega_j / omega * pi))));
  };
  const S a1 = amplitude(m.omega1, c(0));
  const S a2 = amplitude(m.omega2, c(1));
  const S y1 = a1 * S(cos(S(m.omega1 / omega * delta)));
  const S y2 = a2 * S(cos(S(m.omega2 / omega * delta)));
  const S v1 = a1 * m.omega1 * S(sin(S(m.omega1 / omega * delta)));
  const S v2 = a2 * m.omega2 * S(sin(S(m.omega2 / omega * delta)));
  const Vector2<S> z(S(y1 + y2), S(m.lambda1 * y1 + m.lambda2 * y2));
  Vector4<S> Z0 = F<S>(Q, omega, S(mu - delta));
  Vector4<S> ZB = F<S>(Q, omega, S(mu + delta));
  Z0.template head<2>() += z;
  ZB.template head<2>() += z;
  Z0(2) += v1 + v2;
  ZB(2) -= v1 + v2;
  Z0(3) = V;
  ZB(3) = V;
  return {Z0, ZB};
}

// (34), (35): the half-period orbit, V = 0, tau = pi/omega.
template <class S>
struct HalfPeriod {
  S phi1, phi2;  // phi_i = omega_i tan(omega_i pi/(2 omega))
  S d;           // chi/(omega1² - omega2²)
  S a1, a2, b1, b2;
  S friction_speed;  // b1 d01 + b2 d02 = -q2 omega sin(phi)
};

// Assumes omega_i ≠ (2k + 1) omega.
template <class S>
[[nodiscard]] HalfPeriod<S> half_period(const S& chi, const Modes<S>& m, const Vector2<S>& d0, const S& omega,
                                        const S& pi) {
  using std::cos;
  using std::sin;
  const auto slope = [&](const S& omega_i) {
    const S half = omega_i * pi / (S(2) * omega);
    return S(omega_i * S(sin(half)) / S(cos(half)));
  };
  const S phi1 = slope(m.omega1);
  const S phi2 = slope(m.omega2);
  const S d = chi / (m.omega1 * m.omega1 - m.omega2 * m.omega2);
  const S b1 = d * (phi1 - phi2) * m.lambda1 * m.lambda2;
  const S b2 = d * (m.lambda2 * phi2 - m.lambda1 * phi1);
  return {phi1,
          phi2,
          d,
          S(d * (phi1 * m.lambda2 - phi2 * m.lambda1)),
          S(d * (phi2 - phi1)),
          b1,
          b2,
          S(b1 * d0(0) + b2 * d0(1))};
}

// (34): (z10, z20, z10', V = 0).
template <class S>
[[nodiscard]] Vector4<S> half_period_start(const HalfPeriod<S>& h, const Vector2<S>& Q, const Vector2<S>& d0,
                                           const S& omega, const S& cos_phi, const S& sin_phi) {
  return {S(Q(0) * cos_phi - d0(0)), S(Q(1) * cos_phi - d0(1)),
          S(-Q(0) * omega * sin_phi - h.a1 * d0(0) - h.a2 * d0(1)), S(0)};
}

// The load amplitude above which (36) can hold, by (35): since chi eta (q2 - q1) - p = omega² q2 (the second
// row of (7)), (36) is omega² q2 cos(phi) > eta ur, and with (35)
//   p > |D/(omega (1 - omega²))| sqrt((b1 d01 + b2 d02)² + (eta ur/omega)²),
// D = (omega² - omega1²)(omega² - omega2²). With ur = 0 this is the paper's (37). The result is the square.
template <class S>
[[nodiscard]] S least_load_squared(const Parameters<S>& a, const Modes<S>& m, const HalfPeriod<S>& h,
                                   const S& ur) {
  const S w = a.omega * a.omega;
  const S D = (w - m.omega1 * m.omega1) * (w - m.omega2 * m.omega2);
  const S factor = D / (a.omega * (S(1) - w));
  const S step = a.eta * ur / a.omega;
  return factor * factor * (h.friction_speed * h.friction_speed + step * step);
}

// Appendix 5: what decides whether a motion with two slip phases must be symmetric, (63), (70).

// (63): H_2⁻¹(t)(H_1(t) + I): P_1 at t = tau, -P_2 at t = tau_1. Assumes sin(omega_j t) ≠ 0.
template <class S>
[[nodiscard]] Matrix2<S> speed_from_place(const Modes<S>& m, const S& t) {
  const Blocks<S> h = H_blocks(m, t);
  return inverse<S>(h.second) * Matrix2<S>(h.first + identity2<S>());
}

// (70): rho_i = omega_i sin(alpha_i + beta_i)/(sin(alpha_i) sin(beta_i)), alpha_i = omega_i tau/2, beta_i =
// omega_i tau_1/2: the eigenvalues of P = P_1 - P_2. Assumes that neither sine is zero.
template <class S>
[[nodiscard]] S rho(const S& omega_i, const S& tau, const S& tau1) {
  using std::sin;
  const S alpha = omega_i * tau / S(2);
  const S beta = omega_i * tau1 / S(2);
  return S(omega_i * S(sin(S(alpha + beta))) / (S(sin(alpha)) * S(sin(beta))));
}

}  // namespace stickslip::model
