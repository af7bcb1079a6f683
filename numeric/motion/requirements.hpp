// What the friction law (2), (4) demands of each family of orbits, as data.
//
// Where it comes from. On a slip x2'' = eta (us - r), on an overshoot x2'' = eta (-us - r), on a stick u = r,
// with r of (4), and chi (x2 - x1) = chi (z2 - z1) + us. Hence, when a slip from below ends with z2' = V:
//   |r| < ur    it sticks                                            (14), (19): -ur < r < ur
//   r < -ur     u = -us, x2'' = eta (-us - r) > 0: it overshoots     (18), (26)
// and when an overshoot or a stick ends:
//   r > ur      u = us, x2'' = eta (us - r) < 0: it slips below      (25)
//   r = ur      reached from below at the end of a stick: it slips   (12)
// With eta r = chi eta (z2 - z1) + eta us - p cos(omega t + phi) these read as in the paper, in particular
//   (14), (19)  -eta (ur + us) < chi eta (z2C - z1C) - p cos(omega t_C + phi) < eta (ur - us).
// For the symmetric orbit the middle of (14) is -eta (ur - us), by (12), (13) and phi = (pi - omega tau)/2.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "numeric/motion/infimum.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

enum class Family {
  symmetric,     // slip, stick: Section 4
  overshooting,  // slip, overshoot, stick: Section 5
  nonsticking,   // slip, overshoot: Section 6 and its extension to V not 0
};

// A signed distance, positive where the condition holds; written for the paper's own scaling, so a length.
enum class Quantity {
  below_belt,         // V - x2'
  above_belt,         // x2' - V
  below_ur,           // eta (ur - r)
  above_minus_ur,     // eta (ur + r)
  beyond_ur,          // eta (r - ur)
  beyond_minus_ur,    // eta (-ur - r)
  falls_behind,       // eta (r - us) = -x2''(0+), with the premise r = ur
  duration,           // of the phase
  slipping_friction,  // us
  friction_step,      // ur - us
};

// One condition of a family, as data.
struct Requirement {
  std::string id;         // the paper's equation, or a word where it has no number
  std::string statement;  // in the paper's symbols
  Quantity quantity = Quantity::duration;
  std::size_t phase = 0;
  bool along = false;  // over the whole closed phase; else at its beginning
  Touches touches;     // where the distance is zero by construction: the premises z2' = V, r = ur
  bool strict = true;  // > 0; else >= 0
};

// All conditions of a family. For the non-sticking one those that need ur, (25), (26) and ur > us, are left
// out unless `ur_given`.
[[nodiscard]] std::vector<Requirement> requirements(Family family, bool ur_given = true);

// The kinds of the phases of a family in their order.
[[nodiscard]] std::vector<PhaseKind> phase_kinds(Family family);

}  // namespace stickslip::numeric::motion
