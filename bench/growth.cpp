// How the time grows: with the number of boxes that an interval of parameters is cut into, with the number of
// parameters that are intervals, with the periods simulated. Growth with the digits: one_orbit.cpp.
#include <benchmark/benchmark.h>

#include <array>

#include "bench/examples.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/simulation/simulation.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

namespace stickslip::bench {

using namespace numeric;
using namespace numeric::families;
using namespace numeric::motion;
using namespace numeric::simulation;
using namespace proofs::pascal2012;

namespace {

constexpr double half_width = 1e-5;

void prove_admissible(benchmark::State& state, const Problem& s, const model::Parameters<Ball>& a) {
  const ClosedMotion closed = proved_over(s, {a});
  require_proved(state, admissible(conditions(s.family, closed, friction_of(s.family, closed))));
}

// chi of example S over one interval, in so many boxes side by side.
void growth_boxes(benchmark::State& state) {
  const Problem s = problem("S");
  const long boxes = state.range(0);
  model::Parameters<Ball> a = parameters_as<Ball>(data("S"));
  const Ball middle = a.chi;
  for (auto _ : state) {
    for (long k = 0; k < boxes; ++k) {
      const auto end = [&](long i) {
        return middle + Ball(half_width) * (Ball(2 * i) / Ball(boxes) - Ball(1));
      };
      a.chi = Ball::hull(end(k), end(k + 1));
      prove_admissible(state, s, a);
    }
  }
}

// The first so many parameters of example S as intervals.
void growth_parameters(benchmark::State& state) {
  const Problem s = problem("S");
  model::Parameters<Ball> a = parameters_as<Ball>(data("S"));
  const std::array<Ball *, 6> all{&a.chi, &a.eta, &a.us, &a.V, &a.omega, &a.p};
  for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i) {
    *all[i] += Ball::hull(Ball(-half_width), Ball(half_width));
  }
  for (auto _ : state) {
    prove_admissible(state, s, a);
  }
}

// Example O.
void growth_periods(benchmark::State& state) {
  const Start s = start_of(printed_orbit(example_named("O")));
  for (auto _ : state) {
    Simulation simulation(s.data, s.ur, s.phi, s.X);
    for (long k = 0; k < state.range(0); ++k) {
      simulation.advance(simulation.period(), nullptr);
    }
    benchmark::DoNotOptimize(simulation.state());
  }
}

BENCHMARK(growth_boxes)->RangeMultiplier(4)->Range(1, 64)->Unit(benchmark::kMillisecond);
BENCHMARK(growth_parameters)->DenseRange(1, 6)->Unit(benchmark::kMillisecond);
BENCHMARK(growth_periods)->RangeMultiplier(10)->Range(10, 10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stickslip::bench
