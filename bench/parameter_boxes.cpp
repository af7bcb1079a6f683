// Existence and every condition over one box of parameters, in which each of them has the half width that the
// name tells; items are boxes.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"
#include "numeric/motion/shooting.hpp"

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

void prove_boxes(benchmark::State& state, const Problem& s, const Given<Ball>& given) {
  for (auto _ : state) {
    const ClosedMotion closed = prove_closed_over(s.equations, given, s.guess);
    require_proved(state, closed.existence);
    const Ball ur = given.ur.value_or(friction_of(s.family, closed));
    require_proved(state, admissible(conditions(s.family, closed, ur)));
  }
  state.SetItemsProcessed(state.iterations());
}

void box_S(benchmark::State& state) {
  prove_boxes(state, problem("S"), {box("S", 1e-5)});
}

void box_O_at_phi(benchmark::State& state) {
  prove_boxes(state, problem("O"), {box("O", 1e-7), widened(Ball(0), 1e-7)});
}

void box_O_at_ur(benchmark::State& state) {
  Problem s = problem("O");
  const Ball ur = widened(friction_of(s.family, proved(s, 20)).midpoint(), 1e-7);
  s.equations = Shooting{s.family.phases, false, true};
  prove_boxes(state, s, {box("O", 1e-7), {}, ur});
}

void box_P(benchmark::State& state) {
  prove_boxes(state, problem("P"), {box("P", 1e-5), {}, widened(Ball(Rational(1, 5)), 1e-5)});
}

BENCHMARK(box_S)->Name("box_S, ±1e-5")->Unit(benchmark::kMillisecond);
// Example O lies near a fold: its orbit moves some hundred times as far as the parameters.
BENCHMARK(box_O_at_phi)->Name("box_O_at_phi, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_O_at_ur)->Name("box_O_at_ur, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_P)->Name("box_P, ±1e-5")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stickslip::bench
