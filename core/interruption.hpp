// A person's wish that long work end early: noted by a signal handler, looked at by the work, which then
// returns what it has and says what is missing.
#pragma once

#include <array>
#include <csignal>
#include <utility>
#include <vector>

namespace stickslip {

// While an object of this type lives, an interruption (SIGINT) is only noted; a second one ends the program.
// Not to be nested.
class Interruptible {
 public:
  // Signals beside SIGINT that are taken in the same way.
  explicit Interruptible(const std::vector<int>& others = {});
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  std::vector<std::pair<int, struct sigaction>> previous_;
};

// While an object of this type lives, signals that would end the program are held back, in all of its
// threads; the last of them takes effect when it goes. Programs that are started meanwhile do not inherit
// that. May be nested.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  std::array<struct sigaction, 3> previous_ = {};
};

// Whether an interruption was noted since the living Interruptible was made; false when none lives. From any
// thread.
[[nodiscard]] bool interrupted() noexcept;

}  // namespace stickslip
