#include "core/interruption.hpp"

#include <atomic>

namespace stickslip {
namespace {

std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void note(int /*signal*/) {
  noted = true;
}

}  // namespace

Interruptible::Interruptible() {
  noted = false;
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, &previous_);
}

Interruptible::~Interruptible() {
  ::sigaction(SIGINT, &previous_, nullptr);
  noted = false;
}

bool interrupted() noexcept {
  return noted.load(std::memory_order_relaxed);
}

}  // namespace stickslip
