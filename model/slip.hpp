// Free motion while the mass slips: H of (5), (6), (38), and L of (8).
#pragma once

#include "model/parameters.hpp"

namespace stickslip::model {

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

}  // namespace stickslip::model
