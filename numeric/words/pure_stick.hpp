// Motions that stick for ever, on a belt that stands still.
//
// On a stick with V = 0 x2 rests and x1 - chi x2 oscillates with a fixed amplitude a, so by (4)
//   |r| <= chi (1 - chi) |x2| + chi a + p/eta,
// and the motion never leaves the belt where this is below ur. There are such motions if p/eta < ur. There
// is none if p/eta > ur and 1/omega is no whole number: the mean of r with Fejér's kernel of frequency omega,
// as in pure_slip.hpp, is chi (1 - chi) x2 ± (1 - 1/n) p/eta. A belt that moves takes x2 along until r = ±ur.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric::words {

// Of "some motions stick for ever", decided in rationals; undecided for V = 0 where p/eta = ur, or p/eta
// > ur and 1/omega is a whole number. Assumes the domain of the model.
[[nodiscard]] Verdict pure_stick(const motion::ExactParameters& data, const Rational& ur);

}  // namespace stickslip::numeric::words
