// Proved neighbourhoods of stable orbits, and sets of motions, against simulated motions.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.hpp"
#include "numeric/machines/attractors/machine_attractors.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/machines/basins/set_after.hpp"
#include "numeric/words/complete_list.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/machines/neighbourhoods.hpp"
#include "tests/numeric/machines/one_mass.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

// One mass whose friction falls, in three pieces, and no load: it sticks and slips.
Machine stick_slip() {
  return one_mass(Rational(1), {Rational(1),
                                {{Rational(0), Rational(9, 10), Rational(-1, 2)},
                                 {Rational(1), Rational(2, 5), Rational(0)}}});
}

Eigen::VectorXd start_of_damped() {
  Eigen::VectorXd X(4);
  X << 1.344, 3.70, -0.41, 0.99;
  return X;
}

struct Case {
  Machine machine;
  MachineOrbit orbit;
  Neighbourhood found;
};

Case case_of(const Machine& machine, const Eigen::VectorXd& X, long most_phases) {
  const Settled end = settle(machine, X);
  REQUIRE(end.kind == attractors::Kind::periodic);
  Case result{machine, prove_machine_orbit(machine, end.guess), {}};
  result.found = neighbourhood_of(machine, result.orbit, most_phases);
  CAPTURE(result.found.verdict.reason);
  REQUIRE(result.found.verdict.truth == Truth::proved);
  return result;
}

// From the set's edge and from inside: each return is nearer than the start, and in the end all are at c.
void check_converges(const Case& c, int starts, int returns) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> share(0, 1);
  const auto o = oscillator_as<double>(c.machine);
  Simulation simulation(o, o.omega * c.found.time, zeros::in_double(c.found.centre));
  for (int k = 0; k < starts; ++k) {
    simulation.restart(o.omega * c.found.time,
                       member(c.found, c.found.radius * (k % 2 == 0 ? 0.999 : share(engine)), engine));
    double before = place(c.found, simulation.state());
    for (int i = 0; i < returns; ++i) {
      simulation.advance(simulation.period() * static_cast<double>(c.orbit.periods));
      const double now = place(c.found, simulation.state());
      CHECK(now < std::max(before, 1e-9));
      before = now;
    }
    CHECK(before < 1e-3);
  }
}

}  // namespace

TEST_CASE("a motion taken twice or three times is found to be the shorter one, with a load and without") {
  for (const Machine& machine : {stick_slip(), damped_O()}) {
    const bool has_load = !machine.oscillator.is_autonomous();
    const MachineGuess once = settle(machine, has_load ? start_of_damped() : Eigen::VectorXd::Zero(2)).guess;
    REQUIRE(once.events.size() > 1);
    for (const int times : {2, 3}) {
      MachineGuess again = once;
      for (int k = 1; k < times; ++k) {
        for (MachineGuess::Event event : once.events) {
          event.t += k * once.duration;
          again.events.push_back(event);
        }
      }
      again.duration *= times;
      again.periods *= has_load ? times : 1;
      const MachineOrbit found = prove_machine_orbit(machine, again);
      CHECK(found.existence.truth == Truth::proved);
      CHECK(found.phases.size() == once.events.size());
      CHECK(found.periods == once.periods);
      CHECK(found.period.approximate() == doctest::Approx(once.duration));
    }
  }
}

TEST_CASE("all motions from the neighbourhood of a stable orbit converge to it") {
  const Case O = case_of(damped_O(), start_of_damped(), 1500);
  CHECK(O.found.half_widths(1) > 5e-3);
  CHECK(O.found.boxes > 1);
  for (Eigen::Index k = 0; k < 4; ++k) {
    CHECK(O.found.alone(k) > 0);
    CHECK(O.found.alone(k) <= O.found.half_widths(k));
    // Along one coordinate the set ends there.
    Eigen::VectorXd X = zeros::in_double(O.found.centre);
    X(k) += O.found.alone(k);
    CHECK(place(O.found, X) == doctest::Approx(1));
  }
  check_converges(O, 2000, 110);
  Eigen::VectorXd X(4);
  X << 1.56, 3.33, 0.15, -0.1;
  for (std::uint64_t seed = 1; settle(P_with_period_3(), X).guess.periods != 3; ++seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-2, 2);
    for (double& x : X) {
      x = uniform(engine);
    }
  }
  const Case P = case_of(P_with_period_3(), X, 3000);
  CHECK(P.orbit.periods == 3);
  CHECK(P.found.half_widths(1) > 1e-3);
  check_converges(P, 500, 30);
}

TEST_CASE("a neighbourhood is as large in whatever units the machine stands") {
  const Case O = case_of(damped_O(), start_of_damped(), 300);
  const Rational l(1, 1000), t(7);
  const Machine other = in_other_units(damped_O(), l, t);
  Eigen::VectorXd X = start_of_damped() * l.get_d();
  X.tail(2) *= t.get_d();
  const Case same = case_of(other, X, 300);
  for (Eigen::Index k = 0; k < 4; ++k) {
    const double unit = l.get_d() * (k < 2 ? 1 : t.get_d());
    CHECK(same.found.half_widths(k) == doctest::Approx(unit * O.found.half_widths(k)).epsilon(0.2));
    CHECK(same.found.alone(k) == doctest::Approx(unit * O.found.alone(k)).epsilon(0.2));
  }
}

TEST_CASE("the derivative of the return map contracts everywhere in a neighbourhood, and need not outside") {
  const Case O = case_of(damped_O(), start_of_damped(), 1500);
  const auto o = oscillator_as<double>(O.machine);
  const Eigen::MatrixXd S = zeros::in_double(O.found.S), inverse = zeros::in_double(O.found.inverse);
  Simulation simulation(o, 0, zeros::in_double(O.found.centre));
  const auto returned = [&](const Eigen::VectorXd& X) -> Eigen::VectorXd {
    simulation.restart(o.omega * O.found.time, X);
    simulation.advance(simulation.period());
    return simulation.state();
  };
  std::mt19937_64 engine(2);
  const auto largest = [&](double size) {
    double norm = 0;
    for (int k = 0; k < 100; ++k) {
      const Eigen::VectorXd X = member(O.found, size, engine);
      Eigen::MatrixXd D(4, 4);
      const double h = 1e-6 * O.found.radius;
      for (Eigen::Index i = 0; i < 4; ++i) {
        D.col(i) = inverse * (returned(X + S.col(i) * h) - returned(X - S.col(i) * h)) / (2 * h);
      }
      norm = std::max(norm, std::sqrt(zeros::spectral_radius(D.transpose() * D)));
    }
    return norm;
  };
  CHECK(largest(O.found.radius) < 1);
  CHECK(largest(30 * O.found.radius) > 1);
}

TEST_CASE("without a load the neighbourhood lies where a slide ends") {
  Eigen::VectorXd X(2);
  X << -3, 1;
  const Case c = case_of(stick_slip(), X, 1500);
  REQUIRE(c.found.before);
  CHECK(c.found.before->side() != 0);
  CHECK(c.found.alone(0) > 0);
  CHECK(c.found.alone(1) == 0);
  const auto o = oscillator_as<double>(c.machine);
  const Settled end = settle(c.machine, X);
  for (const double share : {-0.999, -0.5, 0.5, 0.999}) {
    Eigen::VectorXd start = zeros::in_double(c.found.centre);
    start(0) += share * c.found.alone(0);
    const Settled reached = settle(c.machine, start);
    REQUIRE(reached.kind == attractors::Kind::periodic);
    CHECK(distance(reached.guess, end.guess) < 1e-6);
  }
}

TEST_CASE("the neighbourhood of a family's orbit is that of the word at the same friction") {
  const OrbitList list = listed(families::overshooting(), O(), 20, Rational(0));
  const auto stable = std::ranges::find_if(list.orbits, &families::is_stable);
  REQUIRE(stable != list.orbits.end());
  const Orbit& orbit = *stable;
  const words::WordQuestion machine = machine_of(list.question, orbit);
  CHECK(abs(Ball(machine.ur) - orbit.ur()).approximate() < 1e-16);
  const Neighbourhood family = neighbourhood_of(machine, orbit, 1, 300);
  REQUIRE(family.verdict.truth == Truth::proved);
  // Of what is no orbit it is not that of one nearby.
  Orbit beside = orbit;
  beside.motion.phases.front().Z(1) += Ball(1e-4);
  CHECK(neighbourhood_of(machine, beside, 1, 300).verdict.reason ==
        "as a machine in tables another orbit is proved");
  const auto same = words::all_orbits(machine, words::Word::parse("OTS"), 1);
  bool found = false;
  for (const words::WordOrbit& word : same.orbits) {
    if (families::is_stable(word.orbit)) {
      const Neighbourhood other = neighbourhood_of(machine, word.orbit, word.periods, 300);
      found = found || (other.centre(1) - family.centre(1)).contains_zero() ||
              std::abs(Ball(other.centre(1) - family.centre(1)).approximate()) < 1e-12;
    }
  }
  CHECK(found);
}

TEST_CASE("an orbit that is not stable has no neighbourhood, nor one that is not proved") {
  const Settled end = settle(damped_O(), start_of_damped());
  MachineOrbit orbit = prove_machine_orbit(damped_O(), end.guess);
  orbit.stability->kind = motion::StabilityKind::unstable;
  CHECK(neighbourhood_of(damped_O(), orbit).verdict.truth == Truth::undecided);
  orbit.existence = Verdict::undecided("for the test");
  CHECK(neighbourhood_of(damped_O(), orbit).verdict.truth == Truth::undecided);
  // The orbit of another machine: the return map does not keep it.
  const MachineOrbit other = prove_machine_orbit(damped_O(), end.guess);
  CHECK(neighbourhood_of(damped_O(Rational(1, 400)), other, 300).verdict.truth != Truth::proved);
}

// Each motion from the box is in what is said of its part.
void check_after(const Machine& machine, const Eigen::VectorXd& middle, const Eigen::VectorXd& half,
                 double time) {
  const SetAfter set = set_after({machine, middle, half, 0, time});
  REQUIRE(set.open.empty());
  CHECK(set.proved() == doctest::Approx(1).epsilon(1e-12));
  const Vector hull = set.hull();
  Simulation simulation(oscillator_as<double>(machine), 0, middle);
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    Eigen::VectorXd X = middle;
    for (Eigen::Index k = 0; k < X.size(); ++k) {
      X(k) += half(k) * uniform(engine);
    }
    simulation.restart(0, X);
    simulation.advance(time);
    bool held = false;
    for (const SetAfter::Part& part : set.parts) {
      bool starts_there = true, ends_there = true;
      for (Eigen::Index k = 0; k < X.size(); ++k) {
        starts_there = starts_there && std::abs(X(k) - part.middle(k)) <= part.half(k);
        ends_there = ends_there && std::abs(simulation.state()(k) - part.states(k).approximate()) <=
                                       part.states(k).radius().approximate() + 1e-9;
      }
      held = held || (starts_there && ends_there);
    }
    CHECK(held);
    CHECK(std::abs(simulation.state()(0) - hull(0).approximate()) <= hull(0).radius().approximate());
  }
}

TEST_CASE("where a box of starts is after some time holds each motion from it") {
  const Machine machine = damped_O();
  Eigen::VectorXd half(4);
  half << 0.003, 0.002, 0, 0.001;
  check_after(machine, start_of_damped(), half, 25);
  // Starts on both sides of the belt's velocity have no one piece: a part around it stays open.
  Eigen::VectorXd through = start_of_damped();
  through(3) = 1;
  half << 0, 0, 0, 0.01;
  const SetAfter both = set_after({machine, through, half, 0, 1, 64});
  CHECK(both.proved() > 0.5);
  CHECK(both.proved() < 1);
  REQUIRE(both.open.size() >= 1);
  double open = 0;
  for (const auto& [reason, share] : both.open) {
    open += share;
  }
  CHECK(open + both.proved() == doctest::Approx(1));
  CHECK_THROWS_AS((void)set_after({machine, through, half, 0, 0}), DomainError);
  CHECK_THROWS_AS((void)set_after({machine, through, -half, 0, 1}), DomainError);
  CHECK_THROWS_AS((void)set_after({machine, through, half.head(3), 0, 1}), DomainError);
}

TEST_CASE("without a load events have their times, too: motions that leave the belt one after the other") {
  Eigen::VectorXd X(2), half(2);
  X << -0.5, 0.2;
  half << 0.01, 0.01;
  for (const double time : {4.0, 11.0, 25.0}) {
    check_after(stick_slip(), X, half, time);
  }
}

TEST_CASE("a set of motions holds each motion from it") {
  const Machine machine = damped_O();
  const auto o = oscillator_as<double>(machine);
  const WorkingPrecision scope(96);
  const SetFlow flow(machine);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int followed = 0;
  for (int k = 0; k < 60; ++k) {
    Eigen::VectorXd X = start_of_damped();
    Eigen::MatrixXd S(4, 4);
    for (double& x : X) {
      x += 0.5 * uniform(engine);
    }
    for (double& x : S.reshaped()) {
      x = 2e-4 * uniform(engine);
    }
    SetOfMotions set = set_at(Ball(0), {}, X.cast<Ball>(), Matrix(S.cast<Ball>()), k % 2 == 0);
    const auto piece = flow.piece_of(set.all.value.tail(4), Ball(0));
    if (!piece) {
      continue;
    }
    set.piece = *piece;
    const double until = 4 + 20 * std::abs(uniform(engine));
    if (flow.follow(set, Ball(until)).truth != Truth::proved) {
      continue;
    }
    ++followed;
    Simulation simulation(o, 0, X);
    for (int i = 0; i < 40; ++i) {
      Eigen::VectorXd e(4);
      for (double& x : e) {
        x = uniform(engine);
      }
      e /= k % 2 == 0 ? std::max(1.0, e.norm()) : 1.0;
      simulation.restart(0, X + S * e);
      simulation.advance(until);
      for (Eigen::Index n = 0; n < 4; ++n) {
        const Ball& range = set.all.value(1 + n);
        CHECK(std::abs(simulation.state()(n) - range.approximate()) <= range.radius().approximate() + 1e-9);
        // Along the middle's derivative, to second order.
        Ball linear = set.middle.value(1 + n);
        for (Eigen::Index l = 0; l < 4; ++l) {
          linear += set.all.first(1 + n, l) * Ball(e(l));
        }
        CHECK(std::abs(simulation.state()(n) - linear.approximate()) <= linear.radius().approximate() + 1e-9);
      }
    }
  }
  CHECK(followed >= 30);
}

TEST_CASE("pixels of a plane are proved to end where their middles do" * doctest::test_suite("nightly") *
          doctest::skip()) {
  MachineBasins basins;
  basins.question.machine = damped_O();
  basins.across = {0, 1};
  const Settled end = settle(basins.question.machine, start_of_damped());
  basins.through = end.state;
  basins.half = {0.0013, 0.0026};
  basins.pixels = {8, 8};
  basins.prove = true;
  basins = in_plane(basins);
  REQUIRE(basins.proved.size() == 64);
  CHECK(proved_share(basins) >= 0.95);
  REQUIRE(!basins.attractors.empty());
  CHECK(basins.attractors[0].word == "OTS");
  // Of a wide plane some pixels hold starts that stick and starts that do not: none of these is proved.
  basins.half = {0.5, 0.5};
  basins.pixels = {2, 2};
  CHECK(proved_share(in_plane(basins)) == 0);
}

TEST_CASE("a pixel is proved with all of its starts, whichever others are looked at together with it") {
  // A ball that motions are in after a part of a slip: the pixels at its edge are not.
  const Machine machine = damped_O();
  const auto o = oscillator_as<double>(machine);
  Eigen::VectorXd X = start_of_damped();
  X(3) = 0.2;
  constexpr double time = 0.25, radius = 0.01;
  Simulation simulation(o, 0, X);
  const auto end_of = [&](const Eigen::VectorXd& start) {
    simulation.restart(0, start);
    std::vector<Simulation::Transition> log;
    simulation.advance(time, &log);
    REQUIRE(log.empty());
    return simulation.state();
  };
  Neighbourhood ball;
  ball.verdict = Verdict::proved();
  ball.piece = {motion::PhaseKind::slip, 0};
  ball.time = time;
  ball.period = simulation.period();
  ball.centre = Eigen::VectorXd(end_of(X)).cast<Ball>();
  ball.S = ball.inverse = Matrix::Identity(4, 4);
  ball.radius = radius;
  Pixels pixels{{}, {0, 3}, {}, {24, 24}};
  Eigen::VectorXd half = Eigen::VectorXd::Zero(4);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    half(pixels.across[axis]) = 2 * radius;
    pixels.half[axis] = 2 * radius / 24;
  }
  pixels.starts = attractors::starts_in_plane<Eigen::VectorXd>(X, half, pixels.across, pixels.count);
  const auto ends = reached(machine, pixels, {std::make_shared<Neighbourhood>(ball)});
  std::size_t proved = 0, inside = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    bool all = true;
    for (const double x : {-pixels.half[0], pixels.half[0]}) {
      for (const double v : {-pixels.half[1], pixels.half[1]}) {
        Eigen::VectorXd corner = pixels.starts[i];
        corner(pixels.across[0]) += x;
        corner(pixels.across[1]) += v;
        all = all && place(ball, end_of(corner)) < 1;
      }
    }
    CHECK((all || !ends[i]));
    proved += ends[i] ? 1 : 0;
    inside += all ? 1 : 0;
  }
  CHECK(proved > inside * 9 / 10);
  CHECK(inside < ends.size());
}

TEST_CASE("a phase ends at its first event, wherever the search for it begins") {
  const Machine machine = damped_O();
  const WorkingPrecision scope(96);
  const SetFlow flow(machine);
  const Eigen::VectorXd X = start_of_damped();
  const Matrix S = Matrix::Identity(4, 4) * Ball(1e-6);
  int proved = 0, refused = 0;
  std::optional<double> first;
  for (double about = 0.5; about < 30; about += 0.5) {
    SetOfMotions set = set_at(Ball(0), {motion::PhaseKind::slip, 0}, X.cast<Ball>(), S, true);
    const Verdict verdict = flow.to_event(set, {motion::PhaseKind::overshoot, 0}, about);
    if (verdict.truth != Truth::proved) {
      ++refused;
      continue;
    }
    ++proved;
    const double time = set.time().approximate();
    CHECK(time == doctest::Approx(first.value_or(time)));
    first = first.value_or(time);
  }
  CHECK(proved > 0);
  CHECK(refused > 0);
}

TEST_CASE("a matrix contracts when no vector becomes longer, for all members") {
  Matrix A = Matrix::Constant(2, 2, Ball(0));
  CHECK(contracts(A));
  A(0, 0) = A(1, 1) = Ball(0.9);
  CHECK(contracts(A));
  A(0, 1) = Ball(0.5);  // the eigenvalues are as before
  CHECK_FALSE(contracts(A));
  A(0, 1) = Ball(-0.1);
  A(1, 0) = Ball(0.1);  // a turn
  CHECK(contracts(A));
  A(1, 1) = Ball::hull(Ball(0.5), Ball(1.1));
  CHECK_FALSE(contracts(A));
  A(1, 1) = Ball(1);
  CHECK_FALSE(contracts(A));
}

TEST_CASE("the ends of a phase, of all motions of a set, are where they are said to be") {
  const Machine machine = damped_O();
  const auto o = oscillator_as<double>(machine);
  const WorkingPrecision scope(96);
  const SetFlow flow(machine);
  Eigen::VectorXd X = start_of_damped();
  X(3) = 0.5;
  Simulation simulation(o, 0, X);
  std::vector<Simulation::Transition> log;
  simulation.advance(10, &log);
  REQUIRE(!log.empty());
  const Eigen::MatrixXd S = Eigen::MatrixXd::Identity(4, 4) * 1e-3;
  SetOfMotions set = set_at(Ball(0), {motion::PhaseKind::slip, 0}, X.cast<Ball>(), S.cast<Ball>(), true);
  const Verdict verdict = flow.to_event(set, {log[0].after, 0}, log[0].time);
  CAPTURE(verdict.reason);
  REQUIRE(verdict.truth == Truth::proved);
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal;
  double least = 1e9, most = -1e9;
  for (int i = 0; i < 500; ++i) {
    Eigen::VectorXd e(4);
    for (double& x : e) {
      x = normal(engine);
    }
    if (i < 2) {  // the earliest and the latest
      e = (i == 0 ? 1 : -1) * zeros::in_double(set.middle.first).row(0).transpose();
    }
    log.clear();
    simulation.restart(0, X + S * e / e.norm());
    simulation.advance(10, &log);
    REQUIRE(!log.empty());
    CHECK(set.all.value(0).overlaps(Ball(log[0].time)));
    least = std::min(least, log[0].time);
    most = std::max(most, log[0].time);
  }
  // Not much wider than they are.
  CHECK(set.all.value(0).radius().approximate() < 1.5 * (most - least) / 2);
}
