// The symmetries that the paper states for all times, (17) and (54), along a motion in balls.
//
// Not sampled: the deviation from the symmetry is itself a wave, a constant, a slope and harmonics of known
// frequencies. The sum of the sizes of its coefficients bounds it at all times, and so the derivative, and a
// coefficient that excludes zero refutes the symmetry, for these functions of time are linearly independent.
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

struct SymmetryAlong {
  // No component of the state deviates more from the symmetry, at any time. Exact.
  Ball bound;
  // Of "it holds at all times": refuted, or undecided with the bound, for balls prove no equality. It holds
  // where the motion closes exactly, by the derivations of Appendix 2 or 4.
  Verdict verdict;
};

// (17): Z(t) = E Z(tau - t) on the slip and Z(t1) = E Z(T - t1) on the stick, t1 = t - tau, over the whole
// closed phases. Throws InternalError unless the phases are slip, stick.
[[nodiscard]] SymmetryAlong symmetry_17(const Motion& motion);

// (54): X(t) = -X(t + tau) for 0 <= t <= tau. Refuted when the two phases do not last equally long. Throws
// InternalError unless the phases are slip, overshoot.
[[nodiscard]] SymmetryAlong symmetry_54(const Motion& motion);

}  // namespace stickslip::numeric::motion
