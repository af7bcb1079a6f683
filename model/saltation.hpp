// How small deviations pass an event of the friction law (4): saltation matrices, and what they need.
//
// Derivation. Let g(Z, t) = 0 be the event, D the gradient of g by Z and g' its rate along the motion just
// before it. A motion that deviates by delta meets the event later by -D delta/g'; over that time the two
// differ by the jump of Z', which is (0, 0, 0, j), j the jump of x2''. Hence
//   delta -> delta + (0, 0, 0, j)ᵀ (D delta)/g'.
// By (2), x2'' = eta (u - r), so with a and a+ the values of x2'' before and after:
//   crossing of the belt, g = x2' - V:   j = a+ - a,  D = (0, 0, 0, 1),  g' = a:  delta2' -> (a+/a) delta2'
//   landing, the same g, then a+ = 0:    delta2' -> 0, a direction collapses
//   break-away, g = r - (±ur), a = 0:    j = a+ = eta (±us - (±ur)),  D = chi (-1, 1, 0, 0),  g' = r'.
#pragma once

#include "model/waves.hpp"

namespace stickslip::model {

// (2), (4): x2'' = eta (u - r).
template <class S>
[[nodiscard]] S belt_acceleration(const S& eta, const S& u, const S& r) {
  return eta * (u - r);
}

// (4): r' = chi (x2' - x1') + (p omega/eta) sin(omega t + phi).
template <class S>
[[nodiscard]] S friction_rate(const Parameters<S>& a, const Vector4<S>& Z, const S& psi) {
  using std::sin;
  return a.chi * (Z(3) - Z(2)) + a.p * a.omega / a.eta * S(sin(psi));
}

// I + (0, 0, 0, jump)ᵀ gradient/rate. Assumes rate ≠ 0.
template <class S>
[[nodiscard]] Matrix4<S> saltation(const S& jump, const Vector4<S>& gradient, const S& rate) {
  const Matrix2<S> zero = diagonal<S>(S(0), S(0));
  Matrix4<S> m = blocks<S>(identity2<S>(), zero, zero, identity2<S>());
  for (int i = 0; i < 4; ++i) {
    m(3, i) += jump * gradient(i) / rate;
  }
  return m;
}

// The belt's speed is crossed with the accelerations x2'' before and after.
template <class S>
[[nodiscard]] Matrix4<S> crossing(const S& before, const S& after) {
  return saltation<S>(S(after - before), Vector4<S>(S(0), S(0), S(0), S(1)), before);
}

// The speed after landing is V whatever it was: exactly zero in the last row.
template <class S>
[[nodiscard]] Matrix4<S> landing() {
  const Matrix2<S> zero = diagonal<S>(S(0), S(0));
  return blocks<S>(identity2<S>(), zero, zero, diagonal<S>(S(1), S(0)));
}

// The stick ends at r = ±ur with the rate r' and the slip begins with the acceleration x2''.
template <class S>
[[nodiscard]] Matrix4<S> break_away(const S& chi, const S& after, const S& rate) {
  return saltation<S>(after, Vector4<S>(S(-chi), chi, S(0), S(0)), rate);
}

}  // namespace stickslip::model
