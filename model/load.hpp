// What the harmonic load and the constant friction add to a slip: Q, R, F of (5), (7) and d0 of (6).
#pragma once

#include "model/slip.hpp"

namespace stickslip::model {

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

}  // namespace stickslip::model
