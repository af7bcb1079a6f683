// The closed forms of the three phases: H, L of (5), (6), (8), (38), the load's part Q, F of (5), (7), Gamma
// of (10), (41).
#pragma once

#include "model/parameters.hpp"

namespace stickslip::model {

// Free motion while the mass slips: H of (5), (6), (38), and L of (8).

// The paper's triple of 2×2 blocks, H_1, H_2, H_3 (38) or Gamma_1, Gamma_2, Gamma_3 (41).
template <class S>
struct Blocks {
  Matrix2<S> first, second, third;
};

// (38): Lambda = [[1, 1], [lambda_1, lambda_2]], whose columns are the eigenvectors of K.
template <class S>
[[nodiscard]] Matrix2<S> Lambda(const Modes<S>& m) {
  return matrix<S>(S(1), S(1), m.lambda1, m.lambda2);
}

// (38): B_2(t) = diag(sin(omega_j t)/omega_j), B_1 = B_2', B_3 = B_2''.
template <class S>
[[nodiscard]] Blocks<S> B(const Modes<S>& m, const S& t) {
  using std::cos;
  using std::sin;
  const S s1 = S(sin(S(m.omega1 * t)));
  const S s2 = S(sin(S(m.omega2 * t)));
  const S c1 = S(cos(S(m.omega1 * t)));
  const S c2 = S(cos(S(m.omega2 * t)));
  return {diagonal<S>(c1, c2), diagonal<S>(S(s1 / m.omega1), S(s2 / m.omega2)),
          diagonal<S>(S(-m.omega1 * s1), S(-m.omega2 * s2))};
}

// (38): H_i(t) = Lambda B_i(t) Lambda⁻¹. Assumes lambda1 ≠ lambda2.
template <class S>
[[nodiscard]] Blocks<S> H_blocks(const Modes<S>& m, const S& t) {
  const Matrix2<S> L = Lambda(m);
  const Matrix2<S> L_inverse = inverse<S>(L);
  const Blocks<S> b = B(m, t);
  return {L * b.first * L_inverse, L * b.second * L_inverse, L * b.third * L_inverse};
}

// (6), (10): [[first, second], [third, first]].
template <class S>
[[nodiscard]] Matrix4<S> assemble(const Blocks<S>& b) {
  return blocks<S>(b.first, b.second, b.third, b.first);
}

// (6): the 4×4 flow of x'' + K x = 0.
template <class S>
[[nodiscard]] Matrix4<S> H(const Modes<S>& m, const S& t) {
  return assemble<S>(H_blocks(m, t));
}

// (8): L(t) = (H_1(t) - I, H_3(t))ᵀ.
template <class S>
[[nodiscard]] Matrix42<S> L(const Modes<S>& m, const S& t) {
  const Blocks<S> h = H_blocks(m, t);
  Matrix42<S> l;
  l.template topRows<2>() = h.first - identity2<S>();
  l.template bottomRows<2>() = h.third;
  return l;
}

// What the harmonic load and the constant friction add to a slip: Q, R, F of (5), (7) and d0 of (6).

// (6): the equilibrium under the friction force +us; d01 = us/(1 - chi), d02 = d01/chi. A length.
template <class S>
[[nodiscard]] Vector2<S> d0(const S& chi, const S& us) {
  const S d01 = us / (S(1) - chi);
  return {d01, S(d01 / chi)};
}

// (7): amplitudes of the forced response, (K - omega² I) Q = (0, p). Assumes omega is neither omega1 nor
// omega2.
template <class S>
[[nodiscard]] Vector2<S> Q(const Parameters<S>& a, const Modes<S>& m) {
  const S w = a.omega * a.omega;
  const S q1 = a.chi * a.p / ((w - m.omega1 * m.omega1) * (w - m.omega2 * m.omega2));
  return {q1, S(q1 * (S(1) - w) / a.chi)};
}

// (5): F(t) = (R(t), R'(t)) with R(t) = Q cos(omega t + phi); psi is the load's phase omega t + phi.
template <class S>
[[nodiscard]] Vector4<S> F(const Vector2<S>& Q, const S& omega, const S& psi) {
  using std::cos;
  using std::sin;
  const S c = S(cos(psi));
  const S s = S(sin(psi));
  const Vector2<S> R = Q * c;
  const Vector2<S> R_dot = Q * S(-omega * s);
  return stack<S>(R, R_dot);
}

// Free motion while the mass sticks to the belt: Gamma of (10), (41).

// (41): Sigma = [[1, chi], [0, 1]].
template <class S>
[[nodiscard]] Matrix2<S> Sigma(const S& chi) {
  return matrix<S>(S(1), chi, S(0), S(1));
}

// (41): gamma_2(t) = diag(sin t, t), gamma_1 = gamma_2', gamma_3 = gamma_2''.
template <class S>
[[nodiscard]] Blocks<S> gamma(const S& t) {
  using std::cos;
  using std::sin;
  const S s = S(sin(t));
  const S c = S(cos(t));
  return {diagonal<S>(c, S(1)), diagonal<S>(s, t), diagonal<S>(S(-s), S(0))};
}

// (41): Gamma_i(t) = Sigma gamma_i(t) Sigma⁻¹.
template <class S>
[[nodiscard]] Blocks<S> Gamma_blocks(const S& chi, const S& t) {
  const Matrix2<S> sigma = Sigma(chi);
  const Matrix2<S> sigma_inverse = inverse<S>(sigma);
  const Blocks<S> g = gamma(t);
  return {sigma * g.first * sigma_inverse, sigma * g.second * sigma_inverse, sigma * g.third * sigma_inverse};
}

// (10): the 4×4 flow of (9).
template <class S>
[[nodiscard]] Matrix4<S> Gamma(const S& chi, const S& t) {
  return assemble<S>(Gamma_blocks(chi, t));
}

// The three closed-form phases. Z = (z, z') with z = x - d0; t is the time since the phase began and psi0 the
// load's phase omega t + phi at that moment.

// (13): E = diag(-I, I). It takes the state of z(t) to that of -z(-t): (z, z') becomes (-z, z').
template <class S>
[[nodiscard]] Matrix4<S> reversal() {
  const Matrix2<S> zero = diagonal<S>(S(0), S(0));
  return blocks<S>(diagonal<S>(S(-1), S(-1)), zero, zero, identity2<S>());
}

// (5): slip with x2' < V, u = us.
template <class S>
[[nodiscard]] Vector4<S> slip_flow(const Modes<S>& m, const Vector2<S>& Q, const S& omega, const S& psi0,
                                   const Vector4<S>& Z0, const S& t) {
  const Vector4<S> F0 = F<S>(Q, omega, psi0);
  return H(m, t) * Vector4<S>(Z0 - F0) + F<S>(Q, omega, S(omega * t + psi0));
}

// (8): slip with x2' > V, u = -us.
template <class S>
[[nodiscard]] Vector4<S> overshoot_flow(const Modes<S>& m, const Vector2<S>& Q, const Vector2<S>& d0,
                                        const S& omega, const S& psi0, const Vector4<S>& Z0, const S& t) {
  const Vector2<S> twice_d0 = d0 * S(2);
  return slip_flow(m, Q, omega, psi0, Z0, t) + L(m, t) * twice_d0;
}

// (10): stick, x2' = V. The load does not enter: the friction balances it.
template <class S>
[[nodiscard]] Vector4<S> stick_flow(const S& chi, const Vector4<S>& Z0, const S& t) {
  return Gamma(chi, t) * Z0;
}

}  // namespace stickslip::model
