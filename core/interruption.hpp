// A person's wish that long work end early: noted by a signal handler, looked at by the work, which then
// returns what it has and says what is missing.
#pragma once

#include <csignal>

namespace stickslip {

// While an object of this type lives, an interruption (SIGINT) is only noted; a second one ends the program.
// Not to be nested.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  struct sigaction previous_ = {};
};

// Whether one was noted since the living Interruptible was made; false when none lives. From any thread.
[[nodiscard]] bool interrupted() noexcept;

}  // namespace stickslip
