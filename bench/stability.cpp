// Floquet multipliers of one proved orbit, enclosed, and what they decide.
#include "numeric/motion/stability.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric::motion;

namespace {

constexpr int digits = 30;

void decide(benchmark::State& state, const Motion& motion) {
  for (auto _ : state) {
    const Stability stability = decide_stability(motion);
    if (stability.kind == StabilityKind::undecided) {
      state.SkipWithError(stability.reason.c_str());
      break;
    }
  }
}

void multipliers_S(benchmark::State& state) {
  decide(state, proved(problem("S"), digits).motion);
}
void multipliers_O(benchmark::State& state) {
  decide(state, proved(problem("O"), digits).motion);
}
void multipliers_P(benchmark::State& state) {
  decide(state, proved(problem("P"), digits).motion);
}

BENCHMARK(multipliers_S)->Unit(benchmark::kMicrosecond);
BENCHMARK(multipliers_O)->Unit(benchmark::kMicrosecond);
BENCHMARK(multipliers_P)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stickslip::bench
