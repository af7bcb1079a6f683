// The three phases in modal form: every coordinate and the friction at rest as a constant, a slope and at
// most three harmonics of time. It says the same as flows.hpp, with each trigonometric function met once.
#pragma once

#include <array>

#include "model/flows.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::model {

// a cos(nu t) + b sin(nu t).
template <class S>
struct Harmonic {
  S nu, a, b;
};

// constant + slope t + the sum of the first `count` harmonics.
template <class S>
struct Wave {
  S constant = S(0);
  S slope = S(0);
  std::array<Harmonic<S>, 3> harmonics;
  int count = 0;

  void add(const S& nu, const S& a, const S& b) {
    harmonics[static_cast<unsigned>(count)] = {nu, a, b};
    ++count;
  }
};

template <class S>
[[nodiscard]] S value(const Wave<S>& w, const S& t) {
  S sum = w.constant + w.slope * t;
  for (int k = 0; k < w.count; ++k) {
    const Harmonic<S>& h = w.harmonics[static_cast<unsigned>(k)];
    const std::pair<S, S> at_t = sin_cos(S(h.nu * t));
    sum += h.a * at_t.second + h.b * at_t.first;
  }
  return sum;
}

// w and w' at t.
template <class S>
[[nodiscard]] std::array<S, 2> value_and_slope(const Wave<S>& w, const S& t) {
  std::array<S, 2> d{S(w.constant + w.slope * t), w.slope};
  for (int k = 0; k < w.count; ++k) {
    const Harmonic<S>& h = w.harmonics[static_cast<unsigned>(k)];
    const std::pair<S, S> at_t = sin_cos(S(h.nu * t));
    const S& s = at_t.first;
    const S& c = at_t.second;
    d[0] += h.a * c + h.b * s;
    d[1] += h.nu * (h.b * c - h.a * s);
  }
  return d;
}

// factor w + offset.
template <class S>
[[nodiscard]] Wave<S> affine(const S& factor, const Wave<S>& w, const S& offset) {
  Wave<S> result = w;
  result.constant = factor * w.constant + offset;
  result.slope = factor * w.slope;
  for (Harmonic<S>& h : result.harmonics) {
    h.a = factor * h.a;
    h.b = factor * h.b;
  }
  return result;
}

template <class S>
[[nodiscard]] Wave<S> derivative(const Wave<S>& w) {
  Wave<S> result = w;
  result.constant = w.slope;
  result.slope = S(0);
  for (Harmonic<S>& h : result.harmonics) {
    h = {h.nu, S(h.b * h.nu), S(-h.a * h.nu)};
  }
  return result;
}

// s -> w(T - s).
template <class S>
[[nodiscard]] Wave<S> reversed(const Wave<S>& w, const S& T) {
  Wave<S> result = w;
  result.constant = w.constant + w.slope * T;
  result.slope = -w.slope;
  for (Harmonic<S>& h : result.harmonics) {
    const std::pair<S, S> at_T = sin_cos(S(h.nu * T));
    const S& s = at_T.first;
    const S& c = at_T.second;
    h = {h.nu, S(h.a * c + h.b * s), S(h.a * s - h.b * c)};
  }
  return result;
}

// What is fixed by the data alone. Assumes omega is no natural frequency.
template <class S>
struct Oscillator {
  Parameters<S> data;
  Modes<S> modes;
  Vector2<S> Q, d0;
};

// For numeric scalars with a square root.
template <class S>
[[nodiscard]] Oscillator<S> oscillator(const Parameters<S>& a) {
  const Modes<S> m = modes<S>(a.chi, a.eta);
  return {a, m, model::Q<S>(a, m), model::d0<S>(a.chi, a.us)};
}

// One phase: the waves of z = x - d0, of z2' and of the friction at rest r of (4).
template <class S>
struct PhaseWaves {
  Wave<S> z1, z2, zdot2, r;
};

// (4): r = chi (x2 - x1) - (p/eta) cos(omega t + phi) = chi (z2 - z1) + us - (p/eta) cos(omega t + phi),
// since chi (d02 - d01) = us by (6). Where r = u_r this is (24). z or (z, z').
template <class S, class Places>
[[nodiscard]] S friction_at(const Parameters<S>& a, const Places& z, const S& psi) {
  using std::cos;
  return a.chi * (z(1) - z(0)) + a.us - a.p / a.eta * S(cos(psi));
}

// (5), (8): slip from Z at load phase psi0; u = us (sign = 1, x2' < V) or u = -us (sign = -1, x2' > V). The
// modal coordinates y = Lambda⁻¹ (z - z_rest - R) oscillate freely; z_rest = 0 or -2 d0.
template <class S>
[[nodiscard]] PhaseWaves<S> slip_waves(const Oscillator<S>& o, int sign, const S& psi0, const Vector4<S>& Z) {
  using std::cos;
  using std::sin;
  const S& omega = o.data.omega;
  const S c = S(cos(psi0));
  const S s = S(sin(psi0));
  const S rest1 = S(sign - 1) * o.d0(0);
  const S rest2 = S(sign - 1) * o.d0(1);
  const S u1 = Z(0) - rest1 - o.Q(0) * c;
  const S u2 = Z(1) - rest2 - o.Q(1) * c;
  const S v1 = Z(2) + omega * o.Q(0) * s;
  const S v2 = Z(3) + omega * o.Q(1) * s;
  const Modes<S>& m = o.modes;
  const S det = m.lambda2 - m.lambda1;
  const S alpha1 = (m.lambda2 * u1 - u2) / det;
  const S alpha2 = (u2 - m.lambda1 * u1) / det;
  const S beta1 = (m.lambda2 * v1 - v2) / (det * m.omega1);
  const S beta2 = (v2 - m.lambda1 * v1) / (det * m.omega2);

  PhaseWaves<S> w;
  w.z1.constant = rest1;
  w.z1.add(m.omega1, alpha1, beta1);
  w.z1.add(m.omega2, alpha2, beta2);
  w.z1.add(omega, S(o.Q(0) * c), S(-o.Q(0) * s));
  w.z2.constant = rest2;
  w.z2.add(m.omega1, S(m.lambda1 * alpha1), S(m.lambda1 * beta1));
  w.z2.add(m.omega2, S(m.lambda2 * alpha2), S(m.lambda2 * beta2));
  w.z2.add(omega, S(o.Q(1) * c), S(-o.Q(1) * s));
  w.zdot2 = derivative(w.z2);
  const S e1 = o.data.chi * (m.lambda1 - S(1));
  const S e2 = o.data.chi * (m.lambda2 - S(1));
  const S forced = o.data.chi * (o.Q(1) - o.Q(0)) - o.data.p / o.data.eta;
  w.r.constant = S(sign) * o.data.us;
  w.r.add(m.omega1, S(e1 * alpha1), S(e1 * beta1));
  w.r.add(m.omega2, S(e2 * alpha2), S(e2 * beta2));
  w.r.add(omega, S(forced * c), S(-forced * s));
  return w;
}

// (9), (10): stick from Z at load phase psi0; z2 moves at the constant speed z2'(0) and z1 - chi z2
// oscillates at frequency 1.
template <class S>
[[nodiscard]] PhaseWaves<S> stick_waves(const Oscillator<S>& o, const S& psi0, const Vector4<S>& Z) {
  using std::cos;
  using std::sin;
  const S& chi = o.data.chi;
  const S a = Z(0) - chi * Z(1);
  const S b = Z(2) - chi * Z(3);
  PhaseWaves<S> w;
  w.z2.constant = Z(1);
  w.z2.slope = Z(3);
  w.z1 = affine<S>(chi, w.z2, S(0));
  w.z1.add(S(1), a, b);
  w.zdot2.constant = Z(3);
  const S stiffness = chi * (S(1) - chi);
  w.r.constant = o.data.us + stiffness * Z(1);
  w.r.slope = stiffness * Z(3);
  w.r.add(S(1), S(-chi * a), S(-chi * b));
  const S load = o.data.p / o.data.eta;
  w.r.add(o.data.omega, S(-load * S(cos(psi0))), S(load * S(sin(psi0))));
  return w;
}

}  // namespace stickslip::model
