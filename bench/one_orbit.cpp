// One orbit: from a guess in double to the proved one, all of its values enclosed to the digits of the
// argument; all conditions along it, for all times; its Floquet multipliers, enclosed, and what they decide.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/stability.hpp"

namespace stickslip::bench {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace proofs::pascal2012;

namespace {

constexpr int digits = 30;

void enclose(benchmark::State& state, const char * example) {
  const Problem s = problem(example);
  for (auto _ : state) {
    benchmark::DoNotOptimize(proved(s, static_cast<int>(state.range(0))));
  }
}

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

void to_digits(benchmark::internal::Benchmark * b) {
  b->ArgName("digits")->Arg(30)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = of_each_example("conditions", decide_all, in_microseconds) &&
                                         of_each_example("enclose", enclose, to_digits) &&
                                         of_each_example("multipliers", decide, in_microseconds);

}  // namespace

}  // namespace stickslip::bench
