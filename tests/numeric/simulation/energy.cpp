// The energy of the difference of two motions: E' = delta2' delta u, and when it can grow.
#include "model/parameters.hpp"

#include <doctest/doctest.h>

#include <array>

#include "numeric/simulation/simulation.hpp"
#include "tests/numeric/simulation/start.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::simulation;
using namespace stickslip::dynamics_tests;

namespace {

constexpr double step = 0.02;

struct Pair {
  Simulation a, b;
  model::Parameters<double> data;

  [[nodiscard]] model::Vector4<double> difference() const { return a.state() - b.state(); }
  [[nodiscard]] double energy() const { return model::energy<double>(data.chi, data.eta, difference()); }
  // delta2' delta u.
  [[nodiscard]] double power() const { return difference()(3) * (a.friction() - b.friction()); }
};

Pair pair_of(const Start& s, const model::Vector4<double>& other) {
  return {Simulation(s.data, s.ur, s.phi, s.X), Simulation(s.data, s.ur, s.phi, other), s.data};
}

// One sticks with |r| > us and the other slips on the side to which r pulls.
bool may_grow(const Simulation& stuck, const Simulation& other, double us) {
  const double r = stuck.friction_at_rest();
  return stuck.phase() == PhaseKind::stick && std::abs(r) > us * (1 - 1e-12) &&
         other.phase() == (r > 0 ? PhaseKind::slip : PhaseKind::overshoot);
}
bool may_grow(const Pair& pair) {
  return may_grow(pair.a, pair.b, pair.data.us) || may_grow(pair.b, pair.a, pair.data.us);
}

// Five-point Gauss quadrature of the power over the next step, during which nothing may change its phase.
double work(Pair pair) {
  constexpr std::array<double, 5> node{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                       0.953089922969332};
  constexpr std::array<double, 5> weight{0.118463442528095, 0.239314335249683, 0.284444444444444,
                                         0.239314335249683, 0.118463442528095};
  double sum = 0;
  double t = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    pair.a.advance(node[k] * step - t);
    pair.b.advance(node[k] * step - t);
    t = node[k] * step;
    sum += weight[k] * pair.power();
  }
  return sum * step;
}

struct Count {
  int quiet = 0, growing = 0, stuck = 0;
};

void follow_pair(Pair pair, bool never_grows, Count& count) {
  for (int k = 0; k < 1000; ++k) {
    const Pair before = pair;
    std::vector<Transition> log;
    pair.a.advance(step, &log);
    pair.b.advance(step, &log);
    const double gain = pair.energy() - before.energy();
    const double rounding = 1e-13 * (1 + before.energy());
    if (never_grows) {
      CHECK(gain <= rounding);
    }
    if (!log.empty()) {
      continue;
    }
    ++count.quiet;
    count.stuck += pair.a.phase() == PhaseKind::stick || pair.b.phase() == PhaseKind::stick ? 1 : 0;
    CHECK(std::abs(gain - work(before)) < rounding);
    if (gain > rounding) {
      ++count.growing;
      CHECK((may_grow(before) || may_grow(pair)));
    }
  }
}

}  // namespace

TEST_CASE("E changes by the work of the difference of friction, and grows only where it may") {
  std::mt19937 random(20121);
  Count count;
  for (int k = 0; k < 60; ++k) {
    Start s = random_start(random);
    model::Vector4<double> other = random_start(random).X;
    follow_pair(pair_of(s, other), false, count);
  }
  MESSAGE("steps " << count.quiet << ", with a stick " << count.stuck << ", growing " << count.growing);
  CHECK(count.quiet > 30000);
  CHECK(count.stuck > 1000);
  CHECK(count.growing > 10);
}

TEST_CASE("with ur = us the energy of a difference never grows") {
  std::mt19937 random(20122);
  Count count;
  for (int k = 0; k < 40; ++k) {
    Start s = random_start(random);
    s.ur = s.data.us;
    model::Vector4<double> other = random_start(random).X;
    follow_pair(pair_of(s, other), true, count);
  }
  CHECK(count.growing == 0);
  CHECK(count.stuck > 500);
}
