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

void enclose_S(benchmark::State& state) {
  enclose(state, "S");
}
void enclose_O(benchmark::State& state) {
  enclose(state, "O");
}
void enclose_P(benchmark::State& state) {
  enclose(state, "P");
}

void digits(benchmark::internal::Benchmark * b) {
  b->ArgName("digits")->Arg(30)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(enclose_S)->Apply(digits);
BENCHMARK(enclose_O)->Apply(digits);
BENCHMARK(enclose_P)->Apply(digits);

}  // namespace
}  // namespace stickslip::bench
