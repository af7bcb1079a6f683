// The symmetric orbit of Section 4: slip on (0, tau), stick on (tau, Theta).
#pragma once

#include "model/flows.hpp"

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

}  // namespace stickslip::model
