// The energy of a deviation, and of a motion.
#pragma once

#include "model/linear.hpp"

namespace stickslip::model {

// E = x1'²/2 + x2'²/(2 eta) + x1²/2 - chi x1 x2 + chi x2²/2 for X = (x1, x2, x1', x2'); positive definite for
// 0 < chi < 1, eta > 0. For the difference delta of two motions (2) under the same load, E' = delta2' delta
// u, delta u the difference of their friction forces.
template <class S>
[[nodiscard]] S energy(const S& chi, const S& eta, const Vector4<S>& X) {
  const S kinetic = X(2) * X(2) + X(3) * X(3) / eta;
  const S elastic = X(0) * X(0) - S(2) * chi * X(0) * X(1) + chi * X(1) * X(1);
  return (kinetic + elastic) / S(2);
}

}  // namespace stickslip::model
