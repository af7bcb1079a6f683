// The three closed-form phases. Z = (z, z') with z = x - d0; t is the time since the phase began and psi0 the
// load's phase omega t + phi at that moment.
#pragma once

#include "model/load.hpp"
#include "model/stick.hpp"

namespace stickslip::model {

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
