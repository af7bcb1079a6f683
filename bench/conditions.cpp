// All conditions along one proved orbit, for all times.
#include "numeric/motion/conditions.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric::families;
using namespace numeric::motion;
using namespace proofs::pascal2012;

namespace {

constexpr int digits = 30;

void decide_all(benchmark::State& state, Family family, const Motion& motion, const Ball& ur) {
  for (auto _ : state) {
    const std::vector<Condition> conditions = decide_conditions(family, motion, ur);
    require_proved(state, admissible(conditions));
  }
}

void conditions_S(benchmark::State& state) {
  const SymmetricOrbit orbit = orbit_S(guess_S(), digits);
  decide_all(state, Family::symmetric, motion_of(data("S"), orbit), orbit.state.ur);
}

void conditions_O(benchmark::State& state) {
  const OvershootingOrbit orbit = orbit_O(guess_O(), digits);
  decide_all(state, Family::overshooting, motion_of(data("O"), orbit), orbit.state.ur);
}

void conditions_P(benchmark::State& state) {
  decide_all(state, Family::nonsticking, orbit_P(guess_P(), digits).motion, Ball(*example_named("P").ur));
}

BENCHMARK(conditions_S)->Unit(benchmark::kMicrosecond);
BENCHMARK(conditions_O)->Unit(benchmark::kMicrosecond);
BENCHMARK(conditions_P)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stickslip::bench
