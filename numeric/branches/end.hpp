// Why a branch, or a path that follows one, ends.
#pragma once

#include <string>

namespace stickslip::numeric::branches {

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
