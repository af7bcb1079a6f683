// Sets of motions: a box of starts of example O over one period of the load, and a neighbourhood of its
// orbit.
#include <benchmark/benchmark.h>

#include "bench/machines.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/machines/basins/set_after.hpp"

namespace stickslip::bench {

using namespace numeric::machines;

namespace {

Machine O() {
  return as_machine("O", "0.45899365993320057");
}

Eigen::VectorXd start() {
  Eigen::VectorXd X(4);
  X << 1.344, 3.70, -0.41, 0.99;
  return X;
}

// Half widths of 10^-k in x1, x2 and x1', a tenth of that in x2'. "growth": the volume of the box around
// where they are, in parts of that of the starts; "proved": the share of these that is decided.
void box_of_starts(benchmark::State& state) {
  const double size = std::pow(10, -static_cast<double>(state.range(0)));
  Eigen::VectorXd half = Eigen::VectorXd::Constant(4, size);
  half(3) = size / 10;
  const Machine machine = O();
  const double period = 2 * 3.141592653589793 / oscillator_as<double>(machine).omega;
  SetAfter set;
  for (auto _ : state) {
    set = set_after({machine, start(), half, 0, period});
  }
  double growth = 1;
  const Vector hull = set.hull();
  for (Eigen::Index k = 0; k < hull.size(); ++k) {
    growth *= hull(k).radius().approximate() / half(k);
  }
  state.counters["parts"] = static_cast<double>(set.parts.size());
  state.counters["growth"] = growth;
  state.counters["proved"] = set.proved();
}

void neighbourhood_O(benchmark::State& state) {
  const Machine machine = O();
  const MachineOrbit orbit = prove_machine_orbit(machine, settle(machine, start()).guess);
  Neighbourhood found;
  for (auto _ : state) {
    found = neighbourhood_of(machine, orbit);
    if (found.verdict.truth != Truth::proved) {
      state.SkipWithError(found.verdict.reason.c_str());
      break;
    }
  }
  state.counters["boxes"] = static_cast<double>(found.boxes);
  state.counters["half_width_of_x2"] = found.half_widths(1);
}

BENCHMARK(box_of_starts)->DenseRange(2, 5)->Apply(in_milliseconds);
BENCHMARK(neighbourhood_O)->Apply(in_milliseconds);

}  // namespace
}  // namespace stickslip::bench
