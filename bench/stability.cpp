// Floquet multipliers of one proved orbit, enclosed, and what they decide.
#include "numeric/motion/stability.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric::motion;

namespace {

constexpr int digits = 30;

void decide(benchmark::State& state, const char * example) {
  const Motion motion = proved(problem(example), digits).motion;
  for (auto _ : state) {
    const Stability stability = decide_stability(motion);
    if (stability.kind == StabilityKind::undecided) {
      state.SkipWithError(stability.reason.c_str());
      break;
    }
  }
}

[[maybe_unused]] const bool registered = of_each_example("multipliers", decide, in_microseconds);

}  // namespace
}  // namespace stickslip::bench
