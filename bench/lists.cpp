// Complete lists at the examples' data, without any guess, every condition decided; the counter tells how
// many cells were examined.
#include <benchmark/benchmark.h>

#include <optional>

#include "bench/examples.hpp"
#include "proofs/methods/motions.hpp"

namespace stickslip::bench {

using namespace proofs::methods;
using proofs::pascal2012::example_named;

namespace {

constexpr int digits = 20;

// The orbits of the example's family, at another u_r if one is given, and their conditions.
void list_all(benchmark::State& state, const char * example, const std::optional<Rational>& ur) {
  numeric::OrbitQuestion question = question_of(example_named(example), digits);
  if (ur) {
    question.phi.reset();
    question.ur = Range{*ur};
  }
  long cells = 0;
  for (auto _ : state) {
    const numeric::OrbitList found = numeric::list_orbits(question);
    if (!found.complete()) {
      state.SkipWithError("the list is not complete");
      break;
    }
    cells = found.cells;
  }
  state.counters["cells"] = static_cast<double>(cells);
}

[[maybe_unused]] const bool registered = [] {
  const auto add = [](const char * name, const char * example, const std::optional<Rational>& ur = {}) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
      list_all(state, example, ur);
    })->Unit(benchmark::kMillisecond);
  };
  add("list_symmetric_S", "S");
  add("list_overshooting_O_at_phi", "O");
  add("list_overshooting_O_at_ur", "O", Rational(459, 1000));
  add("list_nonsticking_P", "P");
  return true;
}();

}  // namespace
}  // namespace stickslip::bench
