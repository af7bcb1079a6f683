// Symmetries of the motion under the friction law, events included. STICKSLIP_SEED in the environment sets
// the random data.
#include "numeric/simulation/simulation.hpp"
#include "tests/numeric/families/random_data.hpp"
#include "tests/numeric/simulation/start.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::simulation;
using namespace stickslip::dynamics_tests;

namespace {

const double half_turn = std::acos(-1.0);

PhaseKind mirrored(PhaseKind kind) {
  return kind == PhaseKind::stick ? kind : kind == PhaseKind::slip ? PhaseKind::overshoot : PhaseKind::slip;
}

// Data at random, or at a corner: a belt that hardly moves, chi near its ends, a load near resonance.
Start corner_start(std::mt19937& random) {
  Start s = random_start(random);
  switch (random() % 6) {
    case 0:
      s.data.V = 1e-6;
      break;
    case 1:
      s.data.chi = 1e-4;
      break;
    case 2:
      s.data.chi = 1 - 1e-4;
      break;
    case 3:
      s.data.omega = model::modes<double>(s.data.chi, s.data.eta).omega1 + 1e-7;
      break;
    default:
      break;
  }
  return s;
}

template <class Check>
void at_random_starts(const Check& check) {
  const examples::RandomData seed;
  INFO("STICKSLIP_SEED=", seed.seed());
  std::mt19937 random(seed.seed());
  for (int i = 0; i < 100; ++i) {
    const Start s = corner_start(random);
    INFO("chi ", s.data.chi, " eta ", s.data.eta, " us ", s.data.us, " V ", s.data.V, " omega ", s.data.omega,
         " p ", s.data.p, " ur ", s.ur, " phi ", s.phi);
    check(s, uniform(random, 1, 30));
  }
}

// The same first events: later ones may part, as small differences grow.
void check_same_events(const Run& a, const Run& b, std::size_t count) {
  constexpr double accuracy = 1e-6;
  for (std::size_t k = 0; k < std::min(count, std::max(a.transitions.size(), b.transitions.size())); ++k) {
    REQUIRE(k < a.transitions.size());
    REQUIRE(k < b.transitions.size());
    CHECK(a.transitions[k].after == b.transitions[k].after);
    CHECK(std::abs(a.transitions[k].time - b.transitions[k].time) < accuracy);
  }
}

constexpr std::size_t first_events = 3, all_events = 1000000;

}  // namespace

TEST_CASE("x to -x with phi to phi + pi and V to -V: the same motion mirrored") {
  at_random_starts([](const Start& s, double duration) {
    Start other = s;
    other.data.V = -s.data.V;
    other.phi = s.phi + half_turn;
    other.X = -s.X;
    Run run = follow(s, duration);
    for (Transition& transition : run.transitions) {
      transition.after = mirrored(transition.after);
    }
    check_same_events(run, follow(other, duration), first_events);
  });
}

TEST_CASE("(x, us, ur, p, V) to 4 (x, us, ur, p, V): the same events at the same times") {
  at_random_starts([](const Start& s, double duration) {
    Start other = s;
    other.data.us *= 4;
    other.data.p *= 4;
    other.data.V *= 4;
    other.ur *= 4;
    other.X *= 4;
    const Run run = follow(s, duration), large = follow(other, duration);
    check_same_events(run, large, all_events);  // a power of two scales without rounding
    CHECK((large.end - 4 * run.end).lpNorm<Eigen::Infinity>() < 1e-6);
  });
}

TEST_CASE("a motion taken up later, with the load as it is then, is the same motion") {
  at_random_starts([](const Start& s, double duration) {
    Simulation whole(s.data, s.ur, s.phi, s.X);
    whole.advance(duration / 2);
    if (whole.phase() == PhaseKind::stick) {
      return;  // a start at the belt's speed may only be touching it
    }
    const Run rest = follow({s.data, s.ur, s.phi + s.data.omega * whole.time(), whole.state()}, duration / 2);
    std::vector<Transition> log;
    const double begin = whole.time();
    whole.advance(duration / 2, &log);
    for (Transition& transition : log) {
      transition.time -= begin;
    }
    check_same_events({log, whole.state()}, rest, first_events);
  });
}
