// The inequalities that a closed motion must obey to be an orbit of the friction law (2), (4), decided for
// all times of each phase, ends included.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/motion/infimum.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/motion/requirements.hpp"

namespace stickslip::numeric::motion {

struct Condition {
  std::string id;
  std::string statement;
  Verdict verdict;
  // The smallest signed distance. Along a phase it is the weighted infimum of infimum.hpp: the infimum of the
  // distance divided by min(1, time to the touched ends); at a point or for a number, the distance itself.
  std::optional<Ball> margin;
  std::optional<Ball> at;  // a time at which it has that margin, from the beginning of the motion
  // When refuted along a phase or at a point; its time counts from the beginning of the motion.
  std::optional<Violation> violation;
};

// Fills in the verdict on "value > 0", >= 0 unless strict; `what` the value is, as in "the duration".
void judge(Condition& condition, const Ball& value, bool strict, const char * what);

// A distance along a phase, and where it is zero by the premise of that name.
struct Along {
  const Course& g;
  const Course& reversed;  // as weighted_infimum wants it
  DerivativeBounds bounds;
  Ball start, duration;  // of the phase
  Touches touches;
  const char * premise;
  bool strict = true;
};
void judge_along(Condition& condition, const Along& along);

// Decides one requirement. Proved and refuted hold for all members of the balls in `motion` and `ur`, under
// the premise that they contain an orbit that closes with z2' = V between its phases and, for (12), r = ur:
// that is what an existence proof says. A premise that a ball excludes makes the verdict refuted. Undecided:
// the margin contains zero, or a touched end is left with a speed whose ball contains zero. Throws
// InternalError when the requirement needs ur and none is given.
[[nodiscard]] Condition decide(const Motion& motion, const std::optional<Ball>& ur,
                               const Requirement& requirement);

// Decides all requirements on a motion through phases of these kinds, with the waves of all phases known.
// When the motion's phases are others, or a gap between them excludes zero, every condition is refuted with
// that reason. ur may be missing when no requirement needs it (InternalError).
[[nodiscard]] std::vector<Condition> decide_all(const std::vector<PhaseKind>& kinds,
                                                const Requirements& requirements, const Motion& motion,
                                                const std::vector<model::PhaseWaves<Ball>>& waves,
                                                const std::optional<Ball>& ur);

// "All of them hold": proved is what `admissible` means.
[[nodiscard]] Verdict admissible(const std::vector<Condition>& conditions);

// Whether the motion can be a closed one through phases of these kinds: undecided unless a gap or the order
// of phases refutes it, for balls cannot prove that it closes.
[[nodiscard]] Verdict closes(const std::vector<PhaseKind>& kinds, const Motion& motion);

}  // namespace stickslip::numeric::motion
