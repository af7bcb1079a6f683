// The stability of a periodic orbit by its Floquet multipliers: the eigenvalues of the derivative of the map
// over one period of the load.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/motion/conditions.hpp"
#include "numeric/motion/eigenvalues.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

enum class StabilityKind {
  stable,     // asymptotically: |mu| < 1 for each multiplier, proved
  unstable,   // |mu| > 1 for some multiplier, proved
  marginal,   // mu = 1 exactly, |mu| < 1 for all others, proved: the linear part decides nothing
  undecided,  // with the reason
};

[[nodiscard]] std::string to_string(StabilityKind kind);

struct Stability {
  StabilityKind kind = StabilityKind::undecided;
  std::string reason;                    // one sentence; empty for stable and unstable
  std::vector<ComplexBall> multipliers;  // all four, largest first; empty when they could not be enclosed
};

// For every member of the balls in `motion`, under the premise that they contain an orbit that closes and
// obeys the friction law: that is what `admissible` says. A motion that sticks has the multiplier 0 exactly:
// landing on the belt collapses a direction. Without load (p exactly 0) it has the multiplier 1 exactly, for
// each shift in time is an orbit too. Undecided when an event may not be transversal, when the multipliers
// cannot be enclosed, and when one of them may lie on the unit circle for no such reason.
[[nodiscard]] Stability decide_stability(const Motion& motion);

// The same from the derivative of a return map, of any size, however its balls were found. `collapses`: a
// direction is lost on the way, so 0 is a multiplier exactly; it is shown as such where a single enclosure
// can hold it. Stable without multipliers where these do not tell, but a quadratic form
// falls along the map.
[[nodiscard]] Stability stability_of(const SquareMatrix& return_map, bool collapses);

// How little it takes to leave a stable orbit: a disturbance that moves the motion by more than the distance
// at which it passes a violation of the friction law may lead to other phases, and the multipliers say
// nothing of these.

struct Contact {
  std::string condition;  // the id of the one that is nearest to a violation
  Ball margin;            // contains the smallest margin of all; a length, as all margins
  Ball at;                // when it has that margin
};

// Of the conditions along the motion, durations and data left out. Nothing unless all of them are proved,
// with margins, and there are some.
[[nodiscard]] std::optional<Contact> contact_of(const std::vector<Condition>& conditions);

}  // namespace stickslip::numeric::motion
