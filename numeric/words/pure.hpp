// Motions that never leave their phase, and those that grow beyond all bounds.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::words {

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

// Motions that stick for ever, on a belt that stands still.
//
// On a stick with V = 0 x2 rests and x1 - chi x2 oscillates with a fixed amplitude a, so by (4)
//   |r| <= chi (1 - chi) |x2| + chi a + p/eta,
// and the motion never leaves the belt where this is below ur. There are such motions if p/eta < ur. There
// is none if p/eta > ur and 1/omega is no whole number: the mean of r with Fejér's kernel of frequency omega,
// as above, is chi (1 - chi) x2 ± (1 - 1/n) p/eta. A belt that moves takes x2 along until r = ±ur.

// Of "some motions stick for ever", decided in rationals; undecided for V = 0 where p/eta = ur, or p/eta
// > ur and 1/omega is a whole number. Assumes the domain of the model.
[[nodiscard]] Verdict pure_stick(const motion::ExactParameters& data, const Rational& ur);

// Motions that a load at a natural frequency drives beyond all bounds.
//
// The friction u on mass 2 is ±us on a slip and r on a stick, so |u| <= ur always. In modal coordinates (39)
// mode j obeys y_j'' + omega_j² y_j = ±(eta u + p cos(omega t))/(lambda2 - lambda1). With omega = omega_j and
// z = (y_j' + i omega y_j) e^{-i omega t}, z' is the right side times e^{-i omega t}: so by its real part
//   |lambda2 - lambda1| |z(t) - z(0)| >= p integral of cos² - eta ur integral of |cos|
//                                     >= (p/2 - 2 eta ur/pi) t - a bound that does not depend on t.
// Hence every motion grows beyond all bounds if pi p > 4 eta ur, whatever the velocity of the belt and
// wherever it begins; a motion that never sticks if pi p > 4 eta us.

// Of "every motion grows beyond all bounds, at least in proportion to the time". Undecided where that
// inequality does not prove it, or ur <= us. Assumes the domain of the model.
[[nodiscard]] Verdict growth(const motion::ExactParameters& data, const Rational& ur);

}  // namespace stickslip::numeric::words
