// Motions that slip, or overshoot, for ever and never touch the belt's speed.
//
// On a slip (5) x2' is the load's harmonic of amplitude |q2| omega and two free ones, of the amplitudes
// alpha_j = |lambda_j| sqrt(omega_j² y_j² + y_j'²) in modal coordinates of what the motion differs from the
// forced one by. Where |q2| omega + alpha1 + alpha2 < V the motion is such a one, for ever; so there are some
// if |q2| omega < V. Free harmonics neither grow nor decay: these motions are neutral, not stable. When the
// frequencies are rationally dependent there may be some with a larger sum too, so a sum that is too large
// refutes nothing.
//
// There is none if V <= 0, for the mean of x2' is 0; nor if |q2| omega > V and no multiple of omega is a
// natural frequency: with Fejér's kernel K_n of frequency omega, which is >= 0 and has the mean 1, the mean
// of x2' K_n(t - t0) is (1 - 1/n) |q2| omega for a fitting t0, and if x2' < V always it is at most V.
//
// For an overshoot all this holds with -V in place of V.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::words {

struct PureSlip {
  Ball forced;     // |q2| omega
  Ball room;       // V - |q2| omega; -V - |q2| omega for an overshoot: what alpha1 + alpha2 is to stay below
  Verdict exists;  // of "some motions slip for ever"
};

// At the working precision. Undecided where |q2| omega is too near V, and where it is above V at a multiple
// of omega that is a natural frequency. Assumes the domain of the model, that omega is no natural frequency,
// and a slip or an overshoot.
[[nodiscard]] PureSlip pure_slip(const motion::ExactParameters& data,
                                 motion::PhaseKind kind = motion::PhaseKind::slip);

}  // namespace stickslip::numeric::words
