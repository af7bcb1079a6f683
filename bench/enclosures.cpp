// From a guess in double to a proved orbit, all of its values enclosed to the digits of the argument.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {
namespace {

void enclose(benchmark::State& state, const char * example) {
  const Problem s = problem(example);
  for (auto _ : state) {
    benchmark::DoNotOptimize(proved(s, static_cast<int>(state.range(0))));
  }
}

void digits(benchmark::internal::Benchmark * b) {
  b->ArgName("digits")->Arg(30)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = of_each_example("enclose", enclose, digits);

}  // namespace
}  // namespace stickslip::bench
