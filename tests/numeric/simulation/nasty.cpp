// Where event logic goes wrong easily: each case with its outcome, no hang, no NaN.
#include <doctest/doctest.h>

#include <cmath>

#include "core/error.hpp"
#include "numeric/simulation/simulation.hpp"
#include "tests/numeric/simulation/start.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::simulation;
using namespace stickslip::dynamics_tests;

namespace {

// Without load: r = chi (x2 - x1).
Start at_friction(double r, double lag) {
  Start s{{0.5, 2.0, 0.1, 1.0, 0.6, 0.0}, 0.3, 0.0, {0, 0, 0, 0}};
  s.X = {0, r / s.data.chi, 1, s.data.V - lag};
  return s;
}

// The greatest x2' of a slip that never meets the belt, and its time, by golden section.
std::pair<double, double> fastest(Start s, double from, double to) {
  s.data.V = 1e3;
  const auto speed = [&](double t) { return follow(s, t).end(3); };
  for (int k = 0; k < 80; ++k) {
    const double a = from + 0.382 * (to - from);
    const double b = from + 0.618 * (to - from);
    (speed(a) > speed(b) ? to : from) = speed(a) > speed(b) ? b : a;
  }
  return {from, speed(from)};
}

model::Modes<double> modes_of(const Start& s) {
  return model::modes<double>(s.data.chi, s.data.eta);
}

}  // namespace

TEST_CASE("two zeros close together in one step are seen, a near miss is none") {
  Start s = lively();
  s.X = {0.2, 0.5, 0, -1};
  const auto [t, V] = fastest(s, 0.5, 4);
  REQUIRE(t > 0.6);
  REQUIRE(t < 3.9);
  for (const Follow& way : both_ways()) {
    for (const double depth : {1e-3, 1e-6, 1e-9, 2e-12}) {
      CAPTURE(depth);
      s.data.V = V - depth;
      const Run touched = way(s, t + 0.1);
      REQUIRE(touched.transitions.size() >= 1);
      CHECK(std::abs(touched.transitions[0].time - t) < 4 * std::sqrt(depth) + 1e-7);
      CHECK(touched.transitions[0].after == PhaseKind::stick);
      s.data.V = V + depth;
      CHECK(way(s, t + 0.1).transitions.empty());
    }
  }
}

TEST_CASE("|r| = ur touched twice within one step of a stick is seen, a near miss is none") {
  Start s = at_friction(0, 0);
  s.data.V = 0;
  s.data.p = 0.5;
  s.phi = std::acos(-1.0) / 2;
  s.X = {0, 0, 0, 0};  // r = (p/eta) sin(omega t), greatest at t
  const double t = s.phi / s.data.omega;
  const double most = s.data.p / s.data.eta;
  for (const Follow& way : both_ways()) {
    for (const double depth : {1e-3, 1e-6, 1e-9, 2e-12}) {
      CAPTURE(depth);
      s.ur = most - depth;
      const Run leaves = way(s, t + 0.1);
      REQUIRE(leaves.transitions.size() >= 1);
      CHECK(leaves.transitions[0].after == PhaseKind::slip);
      CHECK(std::abs(leaves.transitions[0].time - std::asin(s.ur / most) / s.data.omega) < 1e-6);
      s.ur = most + depth;
      CHECK(way(s, t + 0.1).transitions.empty());
    }
  }
}

TEST_CASE("a slip that begins at the belt's speed does not end there") {
  for (const Follow& way : both_ways()) {
    for (const double r : {0.3, 0.31, 1.0}) {
      const Run run = way(at_friction(r, 0), 0.2);
      CHECK(run.transitions.empty());
      CHECK(run.end(3) < 1.0);
    }
    for (const double r : {-0.3, -0.31, -1.0}) {
      CHECK(way(at_friction(r, 0), 0.2).end(3) > 1.0);
    }
  }
}

TEST_CASE("landing: us < |r| < ur sticks, |r| > ur crosses") {
  for (const Follow& way : both_ways()) {
    const Run sticks = way(at_friction(-0.2, 1e-3), 0.1);
    REQUIRE(sticks.transitions.size() == 1);
    CHECK(sticks.transitions[0].after == PhaseKind::stick);
    const Run crosses = way(at_friction(-0.4, 1e-3), 0.1);
    REQUIRE(crosses.transitions.size() == 1);
    CHECK(crosses.transitions[0].after == PhaseKind::overshoot);
    CHECK(crosses.end(3) > 1.0);
    const Run back = way(at_friction(0.4, -1e-3), 0.1);
    REQUIRE(back.transitions.size() == 1);
    CHECK(back.transitions[0].before == PhaseKind::overshoot);
    CHECK(back.transitions[0].after == PhaseKind::slip);
  }
}

TEST_CASE("r at the threshold and next to it: stick at once left, or slip, the same motion") {
  std::vector<Run> runs;
  for (const double excess : {-1e-15, 0.0, 1e-15}) {
    Start s = at_friction(0, 0);
    s.X = {0, s.ur * (1 + excess) / s.data.chi, -1, s.data.V};  // r' = chi (V + 1) > 0
    runs.push_back(follow(s, 3));
    CHECK(runs.back().end(3) != 1.0);
    CHECK((runs.back().end - runs.front().end).lpNorm<Eigen::Infinity>() < 1e-13);
  }
  // Below the threshold the stick has no length.
  REQUIRE_FALSE(runs[0].transitions.empty());
  CHECK(runs[0].transitions[0].before == PhaseKind::stick);
  CHECK(runs[0].transitions[0].time < 1e-14);
}

TEST_CASE("at the threshold with r turning back, us < ur: slips, within it: sticks on") {
  Start s = at_friction(0, 0);
  for (const Follow& way : both_ways()) {
    s.X = {0, s.ur * (1 - 1e-15) / s.data.chi, 3, s.data.V};  // r' < 0
    CHECK(way(s, 0.3).transitions.empty());
    CHECK(way(s, 0.3).end(3) == 1.0);
    s.X(1) = s.ur * (1 + 1e-15) / s.data.chi;
    CHECK(way(s, 0.01).end(3) < 1.0);
  }
}

TEST_CASE("us = ur: the slip begins without acceleration, and the motion goes on") {
  Start s = lively();
  s.ur = s.data.us;
  check_against_raw_law(s, 40, 1e-6);
  Start at_threshold = at_friction(0, 0);
  at_threshold.ur = at_threshold.data.us;
  at_threshold.X = {0, at_threshold.ur / at_threshold.data.chi, -1, at_threshold.data.V};
  for (const Follow& way : both_ways()) {
    at_threshold.X(2) = -1;
    CHECK(way(at_threshold, 0.5).end(3) < 1.0);
    at_threshold.X(2) = 3;  // r' < 0
    CHECK(way(at_threshold, 0.2).end(3) == 1.0);
  }
}

TEST_CASE("V = 0 and a weak load: stuck for ever") {
  Start s = lively();
  s.data.V = 0;
  s.data.p = 0.01;
  s.X = {0.01, 0.02, 0, 0};
  const Run run = follow(s, 1e4);
  CHECK(run.transitions.empty());
  CHECK(run.end(1) == 0.02);
  CHECK(run.end(3) == 0);
}

TEST_CASE("at rest exactly at the threshold, us = ur, no load: it stays") {
  Start s{{0.5, 2.0, 0.25, 0.0, 0.6, 0.0}, 0.25, 0.0, {0.5, 1.0, 0, 0}};  // r = ur, w = x1 - chi x2 = 0
  const Run run = follow(s, 50);
  CHECK((run.end - s.X).lpNorm<Eigen::Infinity>() < 1e-12);
  CHECK_THROWS_AS((void)follow_raw_law(s, 50), InternalError);  // (4) alone says nothing
}

TEST_CASE("V < 0, p = 0") {
  Start s = lively();
  s.data.V = -0.5;
  check_against_raw_law(s, 30, 1e-7);
  s.data.p = 0;
  check_against_raw_law(s, 30, 1e-7);
  s.data.V = 0.5;
  check_against_raw_law(s, 30, 1e-7);
}

TEST_CASE("resonances: omega = omega_i, within 1e-12 of it, omega_i/k, 1") {
  const Start s = lively();
  const model::Modes<double> m = modes_of(s);
  for (const double omega : {m.omega1, m.omega2, m.omega1 + 1e-12, m.omega2 - 1e-12, m.omega1 + 1e-9,
                             m.omega1 / 2, m.omega1 / 3, m.omega2 / 2, m.omega2 / 3, 1.0}) {
    CAPTURE(omega);
    Start resonant = s;
    resonant.data.omega = omega;
    check_against_raw_law(resonant, 25, 1e-7);
  }
}

TEST_CASE("chi near 0 and 1") {
  for (const double chi : {1e-3, 1e-6, 1e-9, 1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1 - 1e-12}) {
    CAPTURE(chi);
    Start s = lively();
    s.data.chi = chi;
    check_against_raw_law(s, 20, 1e-6);
  }
}

TEST_CASE("two events at once: contact while |r| = ur") {
  // r = -ur when x2' meets V: it crosses; a trifle less, and it sticks first, then overshoots.
  for (const double excess : {-1e-15, 0.0, 1e-15}) {
    Start s = at_friction(0, 0);
    s.X = {0, -s.ur * (1 + excess) / s.data.chi, 2, s.data.V - 1e-18};  // rounds to V
    const Run run = follow(s, 0.3);                                     // r' = chi (V - 2) < 0
    CAPTURE(excess);
    CHECK(run.end(3) > 1.0);
    CHECK(is_finite(run));
  }
}

TEST_CASE("extreme data neither hang nor give NaN") {
  for (const double omega : {1e-3, 50.0}) {
    Start s = lively();
    s.data.omega = omega;
    CHECK(is_finite(follow(s, 50)));
  }
  Start s = lively();
  s.ur = 1e3;
  CHECK(is_finite(follow(s, 1000)));
  s = lively();
  s.data.us = 1e-12;
  s.ur = 1e-12;
  CHECK(is_finite(follow(s, 100)));
  s = lively();
  s.X = {1e6, -1e6, 1e6, 1e6};
  CHECK(is_finite(follow(s, 100)));
}

TEST_CASE("at the ends of the domain no step is lost and nothing overflows") {
  Start s;
  long runs = 0;
  const auto try_out = [&] {
    std::vector<Transition> log;
    Simulation simulation(s.data, s.ur, s.phi, s.X);
    CHECK(simulation.advance(1e300, &log, 500) > 0);
    CHECK(log.size() <= 500);
    CHECK(simulation.state().array().isFinite().all());
    ++runs;
  };
  for (const double chi : {1e-100, 0.3, 1 - 1e-15}) {
    for (const double eta : {1e-20, 2.0, 1e20}) {
      for (const double omega : {1e-100, 0.7, 1e10}) {
        for (const double length : {1e-300, 1.0, 1e100}) {
          for (const double size : {0.0, 1.0, 1e100}) {
            for (const double V : {-1e100, 0.0, 1.0}) {
              s.data = {chi, eta, length, V, omega, size};
              s.ur = std::min(1e100, 2 * length);
              s.phi = length;
              s.X = {size, -size, size, V};
              try_out();
              s.X(3) = -size;
              try_out();
            }
          }
        }
      }
    }
  }
  CHECK(runs == 1458);
}

TEST_CASE("a stop and a start again change nothing, also next to an event") {
  const Start s = lively();
  const Run whole = follow(s, 30);
  REQUIRE(whole.transitions.size() > 4);
  for (const double offset : {-1e-9, -1e-16, 0.0, 1e-16, 1e-13, 1e-9}) {
    Simulation simulation(s.data, s.ur, s.phi, s.X);
    std::vector<Transition> log;
    double t = 0;
    for (const Transition& event : whole.transitions) {
      simulation.advance(std::max(0.0, event.time + offset - t), &log);
      t = std::max(t, event.time + offset);
    }
    for (double left = 30 - t; left > 0;) {
      left = simulation.advance(left, &log, 7);
    }
    CHECK(log.size() == whole.transitions.size());
    CHECK((simulation.state() - whole.end).lpNorm<Eigen::Infinity>() < 1e-11);
  }
}

TEST_CASE("what is outside the domain is refused by name") {
  const auto refused = [](const Start& s) { CHECK_THROWS_AS((void)follow(s, 1), DomainError); };
  Start s = lively();
  s.data.chi = 1;
  refused(s);
  s = lively();
  s.ur = s.data.us / 2;
  refused(s);
  s = lively();
  s.X(0) = std::nan("");
  refused(s);
  s = lively();
  s.X(2) = 1e155;
  refused(s);
  s = lively();
  s.data.p = 1e155;
  refused(s);
  CHECK_THROWS_AS((void)follow(lively(), -1), DomainError);
  CHECK_THROWS_AS((void)follow_raw_law(lively(), 0), DomainError);
}
