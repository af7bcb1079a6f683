// The data of equations (2) and (4), and the modes (39).
#pragma once

#include "model/linear.hpp"

namespace stickslip::model {

// The dimensionless data. By (3) time is dimensionless; us, V and p are lengths, as x is.
template <class S>
struct Parameters {
  S chi;    // k2/(k1+k2), 0 < chi < 1
  S eta;    // m1/m2 > 0
  S us;     // slipping friction force, > 0
  S V;      // belt velocity
  S omega;  // load frequency, > 0
  S p;      // load amplitude
};

// f of each.
template <class T, class S, class F>
[[nodiscard]] Parameters<T> mapped(const Parameters<S>& a, const F& f) {
  return {f(a.chi), f(a.eta), f(a.us), f(a.V), f(a.omega), f(a.p)};
}

// Natural frequencies 0 < omega1 < 1 < omega2 and the second components of the eigenvectors (1, lambda_j),
// (39). A caller may take any scalars for the four: a formula that holds for all of them holds for the modes.
template <class S>
struct Modes {
  S omega1;
  S omega2;
  S lambda1;
  S lambda2;
};

// (39): the stiffness matrix K of x'' + K x = (0, eta u + p cos(omega t + phi)).
template <class S>
[[nodiscard]] Matrix2<S> stiffness(const S& chi, const S& eta) {
  return matrix<S>(S(1), S(-chi), S(-chi * eta), S(chi * eta));
}

// (35), from (39): lambda_j = (1 - omega_j²)/chi.
template <class S>
[[nodiscard]] S lambda(const S& chi, const S& omega_j) {
  return (S(1) - omega_j * omega_j) / chi;
}

template <class S>
[[nodiscard]] Modes<S> modes_of(const S& chi, const S& omega1, const S& omega2) {
  return {omega1, omega2, lambda(chi, omega1), lambda(chi, omega2)};
}

// (39) inverted: chi and eta from the frequencies, for 0 < omega1 < 1 < omega2.
template <class S>
[[nodiscard]] S chi_from_frequencies(const S& omega1, const S& omega2) {
  const S a = omega1 * omega1;
  const S b = omega2 * omega2;
  return (S(1) - a) * (b - S(1)) / (a + b - S(1));
}

template <class S>
[[nodiscard]] S eta_from_frequencies(const S& omega1, const S& omega2) {
  const S a = omega1 * omega1;
  const S b = omega2 * omega2;
  const S product = a + b - S(1);  // chi eta
  return product / chi_from_frequencies(omega1, omega2);
}

// (39) solved: the roots of s⁴ - (1 + chi eta) s² + chi eta (1 - chi), for numeric scalars with a square
// root. Assumes 0 < chi < 1 and eta > 0, where the discriminant is positive; the smaller root comes from the
// product of both, without cancellation.
template <class S>
[[nodiscard]] Modes<S> modes(const S& chi, const S& eta) {
  using std::sqrt;
  const S sum = S(1) + chi * eta;
  const S product = chi * eta * (S(1) - chi);
  const S larger = (sum + S(sqrt(S(sum * sum - S(4) * product)))) / S(2);
  return modes_of<S>(chi, S(sqrt(S(product / larger))), S(sqrt(larger)));
}

// Lifting: the same data over a wider scalar, so that data known as numbers enter a formula over jets.

template <class T, class S>
[[nodiscard]] Modes<T> lift(const Modes<S>& m) {
  return {T(m.omega1), T(m.omega2), T(m.lambda1), T(m.lambda2)};
}

template <class T, class S>
[[nodiscard]] Vector2<T> lift(const Vector2<S>& v) {
  return {T(v(0)), T(v(1))};
}

template <class T, class S>
[[nodiscard]] Parameters<T> lift(const Parameters<S>& a) {
  return mapped<T>(a, [](const S& x) { return T(x); });
}

// The energy of a deviation, and of a motion.

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
