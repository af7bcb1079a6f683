// The least load amplitude at which the half-period orbit of Section 6 exists: (36) and x2' < 0 on the whole
// slip.
//
// With B = -q2 omega sin(phi), which (35) fixes whatever the load, and C = q2 omega cos(phi) > 0 the slip has
//   x2'(t) = g(t) + B cos(omega t) - C sin(omega t),  0 <= t <= pi/omega,
// where g is free of the load. It obeys x2' < 0 exactly if C exceeds
//   S = sup over 0 < t < pi/omega of (g(t) + B cos(omega t))/sin(omega t),
// and (36) exactly if C exceeds eta ur/omega. As p/(q2 omega) is fixed by the data, p > least says both.
#pragma once

#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::families {

struct LeastLoad {
  Ball speed_push;     // S
  Ball friction_push;  // eta ur/omega
  Ball p;              // the least |p|
};

// Assumes an orbit with V = 0, tau = Theta/2 and C > 0. S is bracketed between a C for which a time with x2'
// > 0 is proved and one for which there is none; the bracket has `digits` digits. Throws InternalError when
// the motion has no slip of half a period to begin with.
[[nodiscard]] LeastLoad least_load(const motion::Motion& motion, const Ball& ur, int digits);

}  // namespace stickslip::numeric::families
