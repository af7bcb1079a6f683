// Motions that slip for ever and never touch the belt's speed.
//
// On a slip (5) x2' is the load's harmonic of amplitude |q2| omega and two free ones, of the amplitudes
// alpha_j = |lambda_j| sqrt(omega_j² y_j² + y_j'²) in modal coordinates. Where |q2| omega + alpha1 + alpha2 <
// V the motion is such a one, for ever; so there are some if |q2| omega < V. Free harmonics neither grow nor
// decay: these motions are neutral, not stable. When the frequencies are rationally dependent there may be
// some with a larger sum too, so a sum that is too large refutes nothing.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric::words {

struct PureSlip {
  Ball forced;     // |q2| omega
  Verdict exists;  // of "some motions slip for ever": proved or undecided
};

// At the working precision. Assumes the domain of the model and that omega is no natural frequency.
[[nodiscard]] PureSlip pure_slip(const motion::ExactParameters& data);

}  // namespace stickslip::numeric::words
