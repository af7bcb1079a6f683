// Ten periods along each of the paper's orbits, from the middle of the first slip: in closed form with
// certified events, by Boost.Odeint and by CVODE. The counters are times and events per period, and how far
// the end is from the start.
#include <benchmark/benchmark.h>

#include <vector>

#include "bench/cvode_peer.hpp"
#include "bench/odeint_peer.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/simulation/simulation.hpp"
#include "proofs/methods/example_orbits.hpp"
#include "proofs/pascal2012/examples.hpp"

namespace stickslip::bench {

using namespace numeric::simulation;
using namespace proofs::pascal2012;

namespace {

constexpr int periods = 10;
constexpr double tolerance = 1e-10;

const Start& start(long example) {
  static const std::vector<Start> all = [] {
    std::vector<Start> starts;
    for (const auto& e : printed_examples()) {
      starts.push_back(start_of(printed_orbit(e)));
    }
    return starts;
  }();
  return all[static_cast<std::size_t>(example)];
}

double period_of(const Start& s) {
  return 2 * std::acos(-1.0) / s.data.omega;
}

void report(benchmark::State& state, long events, const model::Vector4<double>& end, const Start& s) {
  using benchmark::Counter;
  state.SetLabel(printed_examples()[static_cast<std::size_t>(state.range(0))].name);
  state.counters["per_period"] = Counter(periods, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["events"] = static_cast<double>(events) / periods;
  state.counters["closure"] = (end - s.X).lpNorm<Eigen::Infinity>();
}

void simulate_closed_form(benchmark::State& state) {
  const Start& s = start(state.range(0));
  const Simulation from(s.data, s.ur, s.phi, s.X);
  std::vector<Transition> log;
  model::Vector4<double> end;
  for (auto _ : state) {
    Simulation simulation = from;
    log.clear();
    for (int k = 0; k < periods; ++k) {
      simulation.advance(simulation.period(), &log);
    }
    end = simulation.state();
    benchmark::DoNotOptimize(end);
  }
  report(state, static_cast<long>(log.size()), end, s);
}

void simulate_odeint(benchmark::State& state) {
  const Start& s = start(state.range(0));
  long events = 0;
  model::Vector4<double> end;
  for (auto _ : state) {
    OdeintPeer peer(s, tolerance);
    events = peer.run(periods * period_of(s));
    end = {peer.end()[0], peer.end()[1], peer.end()[2], peer.end()[3]};
    benchmark::DoNotOptimize(end);
  }
  report(state, events, end, s);
}

void simulate_cvode(benchmark::State& state) {
  const Start& s = start(state.range(0));
  Run run;
  for (auto _ : state) {
    run = follow_by_cvode(s, periods * period_of(s), tolerance);
  }
  report(state, static_cast<long>(run.transitions.size()), run.end, s);
}

BENCHMARK(simulate_closed_form)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(simulate_odeint)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(simulate_cvode)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stickslip::bench
