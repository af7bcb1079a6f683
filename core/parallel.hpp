// Independent pieces of work on several threads. What comes out does not depend on how many there are.
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <type_traits>
#include <vector>

#include "core/ball.hpp"

namespace stickslip {

// While an object of this type lives, at most so many threads work (at least 1); without one, as many as
// there are cores. GiNaC's and CLN's objects must not be touched by any but the program's first thread.
class Jobs {
 public:
  explicit Jobs(std::size_t threads) : limit_(tbb::global_control::max_allowed_parallelism, threads) {}

 private:
  tbb::global_control limit_;
};

// f(0), …, f(n - 1) in this order, each at the caller's working precision, possibly at the same time. Throws
// what one of them throws.
template <class F>
[[nodiscard]] auto parallel_map(std::size_t n, const F& f) {
  std::vector<std::invoke_result_t<const F&, std::size_t>> results(n);
  const long bits = WorkingPrecision::bits();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
    const WorkingPrecision scope(bits);
    results[i] = f(i);
  });
  return results;
}

}  // namespace stickslip
