// A mode under constant force and harmonic load over a span of time, regular at every frequency: at resonance
// with the load, where (7) has no Q, and for omega_j → 0.
//
// y'' + omega_j² y = f + P cos(omega t + psi) has the solution
//   y(h)  = c y + s y' + e f + P (C cos psi - S sin psi)
//   y'(h) = -omega_j² s y + c y' + s f + P (C' cos psi - S' sin psi),
// c = cos(omega_j h), s = sin(omega_j h)/omega_j, e = (1 - c)/omega_j² = s²/(1 + c). The load's parts are
//   C(h) = integral of sin(omega_j (h - t))/omega_j cos(omega t) over (0, h)
//        = (cos(omega h) - cos(omega_j h))/(omega_j² - omega²),
// S the same with sin(omega t), where sums become products of half sums a = (omega_j + omega) h/2 and half
// differences b = (omega_j - omega) h/2:
//   C = h²/2 sinc(a) sinc(b),  C' = h/2 (sinc(a) cos(b) + cos(a) sinc(b)),
//   S = h/(2 omega_j) (sinc(a) cos(b) - cos(a) sinc(b)),  S' = omega C.
#pragma once

#include "model/scalar_traits.hpp"

namespace stickslip::model {

template <class S>
struct ModalResponse {
  S c, s, e;             // free motion, constant force
  S stiff;               // omega_j² s
  S from_cos, from_sin;  // C, S
  S cos_rate, sin_rate;  // C', S'
  S load_cos, load_sin;  // of omega h
};

// Assumes omega_j > 0 and cos(omega_j h) ≠ -1.
template <class S>
[[nodiscard]] ModalResponse<S> modal_response(const S& omega_j, const S& omega, const S& h) {
  using std::cos;
  using std::sin;
  const S half = h / S(2);
  const S a = (omega_j + omega) * half;
  const S b = (omega_j - omega) * half;
  const S sin_a = S(sin(a));
  const S cos_a = S(cos(a));
  const S sin_b = S(sin(b));
  const S cos_b = S(cos(b));
  const S sinc_a = S(sinc(a));
  const S sinc_b = S(sinc(b));
  const S sine = sin_a * cos_b + cos_a * sin_b;  // of omega_j h = a + b
  const S c = cos_a * cos_b - sin_a * sin_b;
  const S s = sine / omega_j;
  const S C = h * half * sinc_a * sinc_b;
  return {c,
          s,
          S(s * s / (S(1) + c)),
          S(omega_j * sine),
          C,
          S(half / omega_j * (sinc_a * cos_b - cos_a * sinc_b)),
          S(half * (sinc_a * cos_b + cos_a * sinc_b)),
          S(omega * C),
          S(cos_a * cos_b + sin_a * sin_b),
          S(sin_a * cos_b - cos_a * sin_b)};
}

}  // namespace stickslip::model
