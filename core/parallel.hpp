// Independent pieces of work on several threads. What comes out does not depend on how many there are.
#pragma once

#include <flint/flint.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <type_traits>
#include <vector>

#include "core/ball.hpp"

namespace stickslip {

// While an object of this type lives, at most so many threads work (at least 1); without one, as many as
// there are cores. GiNaC's and CLN's objects are for one thread at a time.
class Jobs {
 public:
  explicit Jobs(std::size_t threads) : limit_(tbb::global_control::max_allowed_parallelism, threads) {}

 private:
  tbb::global_control limit_;
};

// Comes first in what a thread does beside the others: when the thread ends, and all that it kept is gone,
// FLINT gives back what it kept for it. Numbers made there may live on.
inline void give_numbers_back_at_end() {
  struct Cleanup {
    Cleanup() = default;
    Cleanup(const Cleanup&) = delete;
    Cleanup& operator=(const Cleanup&) = delete;
    ~Cleanup() { flint_cleanup(); }
  };
  thread_local const Cleanup first_made_and_last_gone;
}

// f(0), …, f(n - 1) in this order, each at the caller's working precision, possibly at the same time. Throws
// what one of them throws.
template <class F>
[[nodiscard]] auto parallel_map(std::size_t n, const F& f) {
  using Result = std::invoke_result_t<const F&, std::size_t>;
  // Not vector<bool>, whose elements share bytes that two threads would write at one time.
  std::vector<std::conditional_t<std::is_same_v<Result, bool>, char, Result>> results(n);
  const long bits = WorkingPrecision::bits();
  // What oneTBB guarantees anyway, where the thread sanitizer sees it: all of this happens after what came
  // before, and before what comes after, be that a result or an exception.
  std::atomic<std::size_t> done{0};
  struct InOrder {
    std::atomic<std::size_t>& done;
    ~InOrder() { done.fetch_add(1, std::memory_order_acq_rel); }
  };
  done.store(0, std::memory_order_release);
  const InOrder after{done};
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    give_numbers_back_at_end();
    (void)done.load(std::memory_order_acquire);
    const InOrder before{done};
    const WorkingPrecision scope(bits);
    results[i] = f(i);
  });
  return results;
}

}  // namespace stickslip
