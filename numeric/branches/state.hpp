// What is known of the orbits on a piece of a branch, and what changes between two.
#pragma once

#include <string>

namespace stickslip::numeric::branches {

// What the orbits on a piece of a branch are, every one of them.
enum class State {
  outside,       // the parameter is beyond its interval
  absent,        // a phase lasts a negative time: no motion of the family
  inadmissible,  // closed, but a condition of the friction law is violated
  stable,        // admissible: all conditions hold; and by its multipliers
  unstable,
  marginal,    // 1 is a multiplier where there is no load
  admissible,  // and the stability is undecided
  undecided,   // whether the friction law is obeyed, or a phase lasts at all
};
[[nodiscard]] std::string to_string(State state);
[[nodiscard]] bool is_admissible(State state);

enum class ChangeKind {
  fold,       // the branch turns: two orbits on one side meet, none is on the other
  condition,  // a condition is lost or gained, with its id
  stability,  // a multiplier crosses the unit circle: "real +1", "real -1", "complex pair"
  birth,      // a phase lasts no time at all, with the name of its duration: the branch ends
  resonance,  // omega is a natural frequency: of the motions beside it no condition is decided
};
[[nodiscard]] std::string to_string(ChangeKind kind);

// Why a branch, or a path that follows one, ends.

enum class End {
  interval,  // the parameter leaves its interval
  absent,    // a phase lasts no time, and a negative one beyond
  closed,    // it is back where it began: the branch is a closed curve
  infinite,  // the motion grows beyond all bounds
  stopped,   // followed no further, for a reason: the branch may go on
};

// "interval", "birth", "closed", "infinity", "stopped".
[[nodiscard]] std::string to_string(End end);

}  // namespace stickslip::numeric::branches
