// Appendix 5: what decides whether a motion with two slip phases must be symmetric, (62)-(64), (70).
#pragma once

#include "model/flows.hpp"

namespace stickslip::model {

// (62): xi_1 = (X_1, Y_1) and xi_2 = (X_2, Y_2) from z0 - Q cos(phi), zbar0 - Q cos(phi) with zbar = z + 2
// d0, and z0' + Q omega sin(phi).
template <class S>
struct SymmetryDefects {
  Vector2<S> X1, Y1, X2, Y2;
};
template <class S>
[[nodiscard]] SymmetryDefects<S> symmetry_defects(const Modes<S>& m, const S& tau, const S& tau1,
                                                  const Vector2<S>& place, const Vector2<S>& barred_place,
                                                  const Vector2<S>& speed) {
  const Blocks<S> H = H_blocks(m, tau);
  const Blocks<S> h = H_blocks(m, tau1);
  const Matrix2<S> I = identity2<S>();
  return {Matrix2<S>(H.first - I) * place + H.second * speed,
          H.third * place + Matrix2<S>(H.first + I) * speed,
          Matrix2<S>(h.first - I) * barred_place - h.second * speed,
          Matrix2<S>(h.first + I) * speed - h.third * barred_place};
}

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
