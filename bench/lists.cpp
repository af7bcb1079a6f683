// Complete lists at the examples' data, without any guess; the counter tells how many cells were examined.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric::families;

namespace {

constexpr int digits = 20;

template <class Lister>
void list_all(benchmark::State& state, const Lister& list) {
  long cells = 0;
  for (auto _ : state) {
    const auto found = list();
    if (!found.complete()) {
      state.SkipWithError("the list is not complete");
      break;
    }
    cells = found.cells;
  }
  state.counters["cells"] = static_cast<double>(cells);
}

void list_symmetric_S(benchmark::State& state) {
  list_all(state, [] { return list_symmetric(data("S"), digits); });
}
void list_overshooting_O_at_phi(benchmark::State& state) {
  list_all(state, [] { return list_overshooting_at_phase(data("O"), 0, digits); });
}
void list_overshooting_O_at_ur(benchmark::State& state) {
  list_all(state, [] { return list_overshooting_at_friction(data("O"), Rational(459, 1000), digits); });
}
void list_nonsticking_P(benchmark::State& state) {
  list_all(state, [] { return list_nonsticking(data("P"), digits); });
}

BENCHMARK(list_symmetric_S)->Unit(benchmark::kMillisecond);
BENCHMARK(list_overshooting_O_at_phi)->Unit(benchmark::kMillisecond);
BENCHMARK(list_overshooting_O_at_ur)->Unit(benchmark::kMillisecond);
BENCHMARK(list_nonsticking_P)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stickslip::bench
