// Machines in tables, and the paper's as such: proofs of words, and what many starts end on.
#include <benchmark/benchmark.h>

#include "bench/machines.hpp"
#include "numeric/machines/attractors/machine_attractors.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/orbits/motions_over_data.hpp"

namespace stickslip::bench {

using namespace numeric::machines;

namespace {

Eigen::VectorXd of(double a, double b, double c, double d) {
  return Eigen::Vector4d(a, b, c, d);
}

void prove_machine(benchmark::State& state, const Machine& machine, const Eigen::VectorXd& from) {
  const MachineGuess guess = settle(machine, from).guess;
  MachineOrbit orbit;
  for (auto _ : state) {
    orbit = prove_machine_orbit(machine, guess);
  }
  require_proved(state, orbit.admissible);
  state.counters["phases"] = static_cast<double>(orbit.phases.size());
  state.counters["bits"] = static_cast<double>(orbit.bits);
}
BENCHMARK_CAPTURE(prove_machine, P_3, as_machine("P", "0.2996"),
                  of(1.453864542, 3.090387503, 0.4566110742, 1.16512107))
    ->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_machine, P_13, as_machine("P", "0.2996"),
                  of(1.356516811, 2.998053712, 0.438424421, 0.8192487201))
    ->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_machine, two, machine_named("two"), begins_at("two"))->Apply(in_milliseconds);
BENCHMARK_CAPTURE(prove_machine, five, machine_named("five"), begins_at("five"))->Apply(in_milliseconds);

// 1 % of the belt's velocity and of the friction at rest, proved with the state at all of these data: a part.
void box(benchmark::State& state, const Machine& machine, const Eigen::VectorXd& from) {
  const auto at = [&](const Values& data) {
    Machine other = machine;
    other.oscillator.V = data[0];
    other.oscillator.forward.at_rest = other.oscillator.backward.at_rest = data[1];
    return other;
  };
  const Values middle{machine.oscillator.V, machine.oscillator.forward.at_rest};
  DataBox data{at, middle, middle};
  for (std::size_t k = 0; k < middle.size(); ++k) {
    data.low[k] -= middle[k] / 200;
    data.high[k] += middle[k] / 200;
  }
  const std::vector<MotionAt> motions{{middle, settle(machine, from).guess}};
  std::int64_t parts = 0;
  for (auto _ : state) {
    const std::vector<PartOfBox> found =
        motions_over(data, motions, {.most_halvings = 12, .most_parts = 1000});
    parts += static_cast<std::int64_t>(found.size());
    for (const PartOfBox& part : found) {
      require_proved(state, part.existence);
    }
  }
  state.SetItemsProcessed(parts);
}
BENCHMARK_CAPTURE(box, two, machine_named("two"), begins_at("two"))->Apply(in_milliseconds);

void machine_attractors(benchmark::State& state, const Machine& machine) {
  std::int64_t followed = 0;
  for (auto _ : state) {
    followed += find_attractors({.machine = machine, .starts = 500, .most_periods = 2000}).simulated;
  }
  state.SetItemsProcessed(followed);
}
BENCHMARK_CAPTURE(machine_attractors, S, as_machine("S", "0.16096526517987742"))->Apply(in_seconds);
BENCHMARK_CAPTURE(machine_attractors, two, machine_named("two"))->Apply(in_seconds);
BENCHMARK_CAPTURE(machine_attractors, five, machine_named("five"))->Apply(in_seconds);

}  // namespace
}  // namespace stickslip::bench
