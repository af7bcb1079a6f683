// Existence and every condition over one box of parameters, in which each of them has the half width that the
// name tells, and the boxes of an atlas; items are boxes.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"
#include "core/decimal.hpp"
#include "numeric/atlas/judge.hpp"
#include "numeric/atlas/work.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"

namespace stickslip::bench {

using namespace numeric::families;
using namespace numeric::motion;
namespace atlas = numeric::atlas;

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
    const ClosedMotion closed = proved_over(s, given);
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
  s.equations = OvershootingClosing{false, true};
  prove_boxes(state, s, {box("O", 1e-7), {}, ur});
}

void box_P(benchmark::State& state) {
  prove_boxes(state, problem("P"), {box("P", 1e-5), {}, widened(Ball(Rational(1, 5)), 1e-5)});
}

// Every 128th of the 4096 parts of an atlas, judged as far as that goes; items are boxes.
void atlas_of(benchmark::State& state, const Family& family, atlas::Box region, int resolution = 12) {
  const atlas::Question q{&family, std::move(region), {atlas::place_of_omega, atlas::place_of_p}, resolution};
  std::size_t boxes = 0;
  for (auto _ : state) {
    for (atlas::Tile part = 4096 + 37; part < 8192; part += 128) {
      const atlas::Block block = atlas::work_on(q, part, [] { return false; });
      boxes += 2 * block.leaves.size() - 1;
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(boxes));
}

atlas::Interval between(const char * lower, const char * upper) {
  return {parse_rational(lower), parse_rational(upper)};
}
atlas::Interval at(const char * value) {
  return between(value, value);
}

// A box of an atlas around S, its half width range(0) millionths of each of its axes: how many orbits there
// are, every condition along each, its stability. Either nothing is known of it, or the box of twice its size
// around it has told where the orbits are, as in an atlas; `orbits` are judged in each box.
void box_of_atlas_S(benchmark::State& state, bool is_half, const std::vector<std::size_t>& axes) {
  atlas::Question q{
      &symmetric(), {at("0.5"), at("3.8"), at("0.02"), at("1"), at("0.6"), at("0.05")}, axes, 30};
  const Rational share(static_cast<long>(is_half ? 2 * state.range(0) : state.range(0)), 1000000);
  for (const std::size_t k : q.axes) {
    const Rational middle = q.region[k].lower;
    q.region[k] = {middle * (1 - share), middle * (1 + share)};
  }
  atlas::Knowledge around;
  (void)atlas::judge(q, atlas::whole, atlas::Balls::hardware, around);
  std::size_t orbits = 0;
  for (atlas::Knowledge::Sheet& sheet : around.sheets) {
    if (!sheet.orbits) {
      return state.SkipWithError("the orbits around the box are not counted");
    }
    for (atlas::Knowledge::Orbit& orbit : *sheet.orbits) {
      orbit.exists = false;
      orbit.admissible = orbit.stable = Truth::undecided;
      orbit.conditions.clear();
      ++orbits;
    }
  }
  const atlas::Tile tile = is_half ? atlas::Tile{1} << axes.size() : 1;  // the lower half in all parameters
  for (auto _ : state) {
    atlas::Knowledge known = is_half ? around : atlas::Knowledge();
    if (!atlas::judge(q, tile, atlas::Balls::hardware, known).is_decided()) {
      state.SkipWithError("the box is left open");
      return;
    }
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["orbits"] = static_cast<double>(orbits);
}

void atlas_S(benchmark::State& state) {
  atlas_of(state, symmetric(),
           {at("0.5"), at("3.8"), at("0.02"), at("1"), between("0.5", "0.8"), between("0", "0.2")});
}

void atlas_O(benchmark::State& state) {
  atlas_of(
      state, overshooting(),
      {at("0.2"), at("4"), at("0.05"), at("1"), between("0.61", "0.65"), between("0.03", "0.07"), at("0")},
      8);
}

void atlas_P(benchmark::State& state) {
  atlas_of(state, nonsticking(),
           {at("0.3"), at("4"), at("0.1"), at("0"), between("0.5", "0.8"), between("0.5", "1.5"), at("0.2")});
}

BENCHMARK(atlas_S)->Unit(benchmark::kMillisecond);
BENCHMARK(atlas_O)->Unit(benchmark::kMillisecond);
BENCHMARK(atlas_P)->Unit(benchmark::kMillisecond);
const std::vector<std::size_t> two{atlas::place_of_omega, atlas::place_of_p};
const std::vector<std::size_t> four{atlas::place_of_eta, atlas::place_of_V, atlas::place_of_omega,
                                    atlas::place_of_p};
BENCHMARK_CAPTURE(box_of_atlas_S, from_nothing, false, two)
    ->Arg(100)
    ->Arg(500)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(box_of_atlas_S, zeros_known, true, two)->Arg(100)->Arg(240)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(box_of_atlas_S, four_zeros_known, true, four)
    ->Arg(30)
    ->Arg(100)
    ->Arg(240)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(box_S)->Name("box_S, ±1e-5")->Unit(benchmark::kMillisecond);
// Example O lies near a fold: its orbit moves some hundred times as far as the parameters.
BENCHMARK(box_O_at_phi)->Name("box_O_at_phi, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_O_at_ur)->Name("box_O_at_ur, ±1e-7")->Unit(benchmark::kMillisecond);
BENCHMARK(box_P)->Name("box_P, ±1e-5")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stickslip::bench
