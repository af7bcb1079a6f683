// All conditions along one proved orbit, for all times.
#include "numeric/motion/conditions.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace proofs::pascal2012;

namespace {

constexpr int digits = 30;

void decide_all(benchmark::State& state, const char * example) {
  const Problem s = problem(example);
  const ClosedMotion closed = proved(s, digits);
  const std::optional<Rational>& given = example_named(example).ur;
  const Ball ur = given ? Ball(*given) : friction_of(s.family, closed);
  for (auto _ : state) {
    const std::vector<Condition> all = families::conditions(s.family, closed, ur);
    require_proved(state, admissible(all));
  }
}

void conditions_S(benchmark::State& state) {
  decide_all(state, "S");
}
void conditions_O(benchmark::State& state) {
  decide_all(state, "O");
}
void conditions_P(benchmark::State& state) {
  decide_all(state, "P");
}

BENCHMARK(conditions_S)->Unit(benchmark::kMicrosecond);
BENCHMARK(conditions_O)->Unit(benchmark::kMicrosecond);
BENCHMARK(conditions_P)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stickslip::bench
