#include "core/interruption.hpp"

#include <array>
#include <atomic>
#include <cstddef>

namespace stickslip {
namespace {

constexpr std::array<int, 3> ending{SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> noted = false;
std::atomic<int> held = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing else");

extern "C" void note(int /*signal*/) {
  noted = true;
}

extern "C" void hold(int signal) {
  held = signal;
}

}  // namespace

Interruptible::Interruptible(const std::vector<int>& others) {
  noted = false;
  std::vector<int> signals = others;
  signals.push_back(SIGINT);
  for (const int signal : signals) {
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    struct sigaction before = {};
    ::sigaction(signal, &action, &before);
    previous_.emplace_back(signal, before);
  }
}

Interruptible::~Interruptible() {
  for (const auto& [signal, before] : previous_) {
    ::sigaction(signal, &before, nullptr);
  }
  noted = false;
}

Uninterrupted::Uninterrupted() {
  struct sigaction action = {};
  action.sa_handler = hold;
  action.sa_flags = static_cast<int>(SA_RESTART);
  for (std::size_t i = 0; i < ending.size(); ++i) {
    ::sigaction(ending[i], &action, &previous_[i]);
  }
}

Uninterrupted::~Uninterrupted() {
  for (std::size_t i = 0; i < ending.size(); ++i) {
    ::sigaction(ending[i], &previous_[i], nullptr);
  }
  if (const int signal = held.exchange(0); signal != 0) {
    ::raise(signal);
  }
}

bool interrupted() noexcept {
  return noted.load(std::memory_order_relaxed);
}

}  // namespace stickslip
