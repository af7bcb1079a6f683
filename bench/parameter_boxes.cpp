// Existence and every condition over one box of parameters, in which each of them has the half width that the
// name tells; items are boxes.
#include "numeric/families/parameter_box.hpp"

#include <benchmark/benchmark.h>

#include "bench/examples.hpp"

namespace stickslip::bench {

using namespace numeric::families;
using namespace numeric::motion;

namespace {

Ball widened(const Ball& middle, double r) {
  return middle + Ball::hull(Ball(-r), Ball(r));
}

model::Parameters<Ball> box(const char * example, double r) {
  const model::Parameters<Ball> a = parameters_as<Ball>(data(example));
  return {widened(a.chi, r), widened(a.eta, r),   widened(a.us, r),
          widened(a.V, r),   widened(a.omega, r), widened(a.p, r)};
}

template <class Prover>
void prove_boxes(benchmark::State& state, const Prover& prove) {
  for (auto _ : state) {
    const BoxOrbit orbit = prove();
    require_proved(state, orbit.existence);
    require_proved(state, admissible(orbit.conditions));
  }
  state.SetItemsProcessed(state.iterations());
}

void box_S(benchmark::State& state) {
  const Guess guess = guess_S();
  prove_boxes(state, [&] { return prove_symmetric_over(box("S", 1e-5), 1, {guess(0), guess(1)}); });
}

std::vector<double> state_O() {
  const OvershootingState<Ball> s = orbit_O(guess_O(), 20).state;
  return {s.tau.approximate(), s.tau1.approximate(), s.z10.approximate(), s.z20.approximate(),
          s.zdot10.approximate()};
}

void box_O_at_phi(benchmark::State& state) {
  const std::vector<double> guess = state_O();
  prove_boxes(state, [&] { return prove_overshooting_over(box("O", 1e-7), widened(Ball(0), 1e-7), guess); });
}

void box_O_at_ur(benchmark::State& state) {
  std::vector<double> guess = state_O();
  guess.push_back(0);
  const Ball ur = widened(orbit_O(guess_O(), 20).state.ur.midpoint(), 1e-7);
  prove_boxes(state, [&] { return prove_overshooting_at_friction_over(box("O", 1e-7), ur, guess); });
}

void box_P(benchmark::State& state) {
  const Guess guess = guess_P();
  const Ball ur = widened(Ball(Rational(1, 5)), 1e-5);
  prove_boxes(state, [&] { return prove_nonsticking_over(box("P", 1e-5), ur, {guess(0), guess(1)}); });
}

BENCHMARK(box_S)->Name("box_S, ±1e-5")->Unit(benchmark::kMillisecond);
// Example O lies near a fold: its orbit moves some hundred times as far as the parameters.
BENCHMARK(box_O_at_phi)->Name("box_O_at_phi, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_O_at_ur)->Name("box_O_at_ur, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_P)->Name("box_P, ±1e-5")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stickslip::bench
