// Motions that a load at a natural frequency drives beyond all bounds.
//
// The friction u on mass 2 is ±us on a slip and r on a stick, so |u| <= ur always. In modal coordinates (39)
// mode j obeys y_j'' + omega_j² y_j = ±(eta u + p cos(omega t))/(lambda2 - lambda1). With omega = omega_j and
// z = (y_j' + i omega y_j) e^{-i omega t}, z' is the right side times e^{-i omega t}: so by its real part
//   |lambda2 - lambda1| |z(t) - z(0)| >= p integral of cos² - eta ur integral of |cos|
//                                     >= (p/2 - 2 eta ur/pi) t - a bound that does not depend on t.
// Hence every motion grows beyond all bounds if pi p > 4 eta ur, whatever the velocity of the belt and
// wherever it begins; a motion that never sticks if pi p > 4 eta us.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric::words {

// Of "every motion grows beyond all bounds, at least in proportion to the time". Undecided where that
// inequality does not prove it, or ur <= us. Assumes the domain of the model.
[[nodiscard]] Verdict growth(const motion::ExactParameters& data, const Rational& ur);

}  // namespace stickslip::numeric::words
