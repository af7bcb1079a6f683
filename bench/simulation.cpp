// Ten periods along each of the paper's orbits, from the middle of the first slip, and along what machines in
// tables settle on, from load phase 0: in closed form with certified events, by Boost.Odeint and by CVODE.
// The counters are times and events per period, and how far the end is from the start.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bench/cvode_peer.hpp"
#include "bench/machines.hpp"
#include "bench/odeint_peer.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/simulation/simulation.hpp"
#include "proofs/methods/motions.hpp"

namespace stickslip::bench {

using namespace numeric::simulation;
using namespace proofs::pascal2012;

namespace {

constexpr int periods = 10;
constexpr double tolerance = 1e-10;

template <class Simulation>
struct Followed {
  Simulation begun;
  std::unique_ptr<RawLaw> law;
};

Followed<Simulation> paper(int example) {
  static const std::vector<Start> all = [] {
    std::vector<Start> starts;
    for (const auto& e : printed_examples()) {
      starts.push_back(start_of(printed_orbit(e)));
    }
    return starts;
  }();
  const Start& s = all[static_cast<std::size_t>(example)];
  return {{s.data, s.ur, s.phi, s.X}, std::make_unique<PaperLaw>(s)};
}

template <int N, int L>
Followed<SimulationOf<N, L>> machine(const char * name) {
  const numeric::machines::Machine found = machine_named(name);
  const auto o = numeric::machines::oscillator_as<double>(found);
  return {{o, 0, numeric::machines::settle(found, begins_at(name)).state}, std::make_unique<MachineLaw>(o)};
}

void report(benchmark::State& state, std::size_t events, const Eigen::VectorXd& end,
            const Eigen::VectorXd& X) {
  using benchmark::Counter;
  state.counters["per_period"] = Counter(periods, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["events"] = static_cast<double>(events) / periods;
  state.counters["closure"] = (end - X).lpNorm<Eigen::Infinity>();
}

template <class Simulation>
void simulate_closed_form(benchmark::State& state, const Followed<Simulation>& from) {
  std::vector<typename Simulation::Transition> log;
  typename Simulation::State end;
  for (auto _ : state) {
    Simulation simulation = from.begun;
    log.clear();
    for (int k = 0; k < periods; ++k) {
      simulation.advance(simulation.period(), &log);
    }
    end = simulation.state();
    benchmark::DoNotOptimize(end);
  }
  report(state, log.size(), end, from.begun.state());
}

template <class Simulation>
void simulate_odeint(benchmark::State& state, const Followed<Simulation>& from) {
  constexpr std::size_t n = Simulation::states == Eigen::Dynamic ? 10 : 4;
  std::array<double, n> x;
  int events = 0;
  for (auto _ : state) {
    std::ranges::copy(from.begun.state(), x.begin());
    events = follow_by_odeint<n>(*from.law, x, periods * from.begun.period(), tolerance);
  }
  report(state, static_cast<std::size_t>(events), Eigen::Map<Eigen::VectorXd>(x.data(), n),
         from.begun.state());
}

template <class Simulation>
void simulate_cvode(benchmark::State& state, const Followed<Simulation>& from) {
  Eigen::VectorXd x;
  int events = 0;
  for (auto _ : state) {
    x = from.begun.state();
    events = follow_by_cvode(*from.law, {x.data(), static_cast<std::size_t>(x.size())},
                             periods * from.begun.period(), tolerance);
  }
  report(state, static_cast<std::size_t>(events), x, from.begun.state());
}

#define SIMULATED(name, ...)                                                                 \
  BENCHMARK_CAPTURE(simulate_closed_form, name, __VA_ARGS__)->Unit(benchmark::kMicrosecond); \
  BENCHMARK_CAPTURE(simulate_odeint, name, __VA_ARGS__)->Unit(benchmark::kMicrosecond);      \
  BENCHMARK_CAPTURE(simulate_cvode, name, __VA_ARGS__)->Unit(benchmark::kMicrosecond)
SIMULATED(S, paper(0));
SIMULATED(O, paper(1));
SIMULATED(P, paper(2));
SIMULATED(two, machine<2, 1>("two"));
SIMULATED(five, machine<Eigen::Dynamic, Eigen::Dynamic>("five"));

}  // namespace
}  // namespace stickslip::bench
