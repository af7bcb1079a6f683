// Appendix 5: what decides whether a motion with two slip phases must be symmetric, (63), (70).
#pragma once

#include "model/flows.hpp"

namespace stickslip::model {

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
