// From a guess in double to a proved orbit, all of its values enclosed to the digits of the argument.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {
namespace {

void enclose_S(benchmark::State& state) {
  const Guess guess = guess_S();
  for (auto _ : state) {
    benchmark::DoNotOptimize(orbit_S(guess, static_cast<int>(state.range(0))));
  }
}

void enclose_O(benchmark::State& state) {
  const Guess guess = guess_O();
  for (auto _ : state) {
    benchmark::DoNotOptimize(orbit_O(guess, static_cast<int>(state.range(0))));
  }
}

void enclose_P(benchmark::State& state) {
  const Guess guess = guess_P();
  for (auto _ : state) {
    benchmark::DoNotOptimize(orbit_P(guess, static_cast<int>(state.range(0))));
  }
}

void digits(benchmark::internal::Benchmark * b) {
  b->ArgName("digits")->Arg(30)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(enclose_S)->Apply(digits);
BENCHMARK(enclose_O)->Apply(digits);
BENCHMARK(enclose_P)->Apply(digits);

}  // namespace
}  // namespace stickslip::bench
