// Motions that stick for ever, on a belt that stands still.
//
// On a stick with V = 0 x2 rests and x1 - chi x2 oscillates with a fixed amplitude a, so by (4)
//   |r| <= chi (1 - chi) |x2| + chi a + p/eta,
// and the motion never leaves the belt where this is below ur. There are such motions if p/eta < ur. A belt
// that moves takes x2 along until r = ±ur.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric::words {

// Of "some motions stick for ever", decided in rationals; undecided for V = 0 and p/eta >= ur, where the
// bound says nothing. Assumes the domain of the model.
[[nodiscard]] Verdict pure_stick(const motion::ExactParameters& data, const Rational& ur);

}  // namespace stickslip::numeric::words
