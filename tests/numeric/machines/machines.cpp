// Machines of any number of masses: the linear phases against the paper's closed forms, courses against
// flows, chains against the paper's, and orbits with their multipliers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.hpp"
#include "numeric/machines/attractors/machine_attractors.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/attractors/steady_sliding.hpp"
#include "numeric/machines/orbits/judge.hpp"
#include "numeric/machines/orbits/machine_branch.hpp"
#include "numeric/words/word_orbit.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/machines/neighbourhoods.hpp"

using namespace stickslip;
using namespace stickslip::examples;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

// The paper's oscillator with C = share K.
Machine paper(const ExactParameters& data, const Rational& ur, const Rational& share = 0) {
  Machine machine{model::friction_oscillator<Rational>(data, ur)};
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      machine.oscillator.damping(i, k) = Rational(share * machine.oscillator.stiffness(i, k));
    }
  }
  return machine;
}

const Rational ur_of_O("45899365993320057/100000000000000000");

Eigen::VectorXd start_of_O() {
  Eigen::VectorXd X(4);
  X << 1.344, 3.70, -0.41, 0.99;
  return X;
}

// Masses in a row, the last on the belt, whose friction falls with the relative velocity in three pieces.
Machine row_of_masses(int n) {
  Machine machine;
  auto& o = machine.oscillator;
  o.masses.assign(static_cast<std::size_t>(n), Rational(1));
  o.stiffness = model::MatrixX<Rational>::Constant(n, n, Rational(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    o.stiffness(i, i) += Rational(i + 1 < n ? 20 : 10);
    if (i + 1 < n) {
      o.stiffness(i, i + 1) = o.stiffness(i + 1, i) = Rational(-10);
    }
  }
  o.damping = o.stiffness;
  for (Eigen::Index i = 0; i < o.damping.size(); ++i) {
    o.damping.data()[i] = Rational(o.damping.data()[i] / Rational(200));
  }
  o.rubbing = static_cast<std::size_t>(n - 1);
  o.V = Rational("1/2");
  o.forward = {Rational(3),
               {{Rational(0), Rational(2), Rational(-1)},
                {Rational("1/2"), Rational("3/2"), Rational("-1/4")},
                {Rational(2), Rational("9/8"), Rational(0)}}};
  o.backward = o.forward;
  return machine;
}

MachineOrbit settled(const Machine& machine, const Eigen::VectorXd& X) {
  const Settled found = settle(machine, X);
  REQUIRE(found.kind == attractors::Kind::periodic);
  return prove_machine_orbit(machine, found.guess);
}

// Where the guess's motion is at load phase 0.
Eigen::VectorXd start_at_phase_0(const Machine& machine, const MachineGuess& guess) {
  const auto o = oscillator_as<double>(machine);
  const double Theta = 2 * 3.141592653589793 / o.omega;
  simulation::SimulationOf<Eigen::Dynamic, Eigen::Dynamic> s(o, o.omega * guess.events[0].t,
                                                             guess.events[0].X);
  s.advance(Theta - std::fmod(guess.events[0].t, Theta));
  return s.state();
}

// The largest modulus of a multiplier.
double largest_multiplier(const MachineOrbit& orbit) {
  REQUIRE(orbit.stability);
  REQUIRE_FALSE(orbit.stability->multipliers.empty());
  return sqrt(orbit.stability->multipliers.front().squared_modulus()).approximate();
}

bool is_narrow(const Ball& x, double radius) {
  return !(x.radius() - Ball(radius)).is_positive();
}

}  // namespace

TEST_CASE("the flows of linear phases are the paper's closed forms") {
  for (const ExactParameters& data : {S(), O(), P("0.1")}) {
    const LinearPhases phases(oscillator_as<Ball>(paper(data, Rational(1))));
    const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(data));
    const Ball phi(0.3), h(2.7);
    model::Vector4<Ball> Z(Ball(0.4), Ball(-0.2), Ball(0.1), o.data.V);
    Vector X(4);
    X << Z(0) + o.d0(0), Z(1) + o.d0(1), Z(2), Z(3);
    for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
      const model::Vector4<Ball> closed = motion::flow<Ball>(o, kind, phi, Z, h);
      const Vector linear = zeros::product(phases.flow({kind, 0}, h), phases.whole(X, phi));
      for (int i = 0; i < 4; ++i) {
        const Ball expected = i < 2 ? Ball(closed(i) + o.d0(i)) : closed(i);
        CHECK(linear(i).overlaps(expected));
        CHECK(is_narrow(linear(i), 1e-30));
      }
    }
  }
}

TEST_CASE(
    "undamped phases in closed form are the exponentials of their drifts, also where the load resonates") {
  const Rational unit(1, 7);
  for (const int n : {1, 2, 3}) {
    Machine machine = row_of_masses(n);
    auto& o = machine.oscillator;
    o.damping *= Rational(0);
    for (int i = 0; i < n; ++i) {
      o.masses[static_cast<std::size_t>(i)] = Rational(1) + i * unit;
      o.loads.push_back({static_cast<std::size_t>(i), 0, Rational(2) - i, Rational(0)});
      o.loads.push_back({static_cast<std::size_t>(i), 1, Rational(1, 3) + i, unit});
      o.loads.push_back({static_cast<std::size_t>(i), 3, unit, Rational(1 - i)});
    }
    o.forward.sliding = o.backward.sliding = {{Rational(0), Rational(2), Rational(0)}};
    // The second is 1e-10 beside sqrt(20), the frequency of a mass between two springs.
    for (const Rational& omega : {Rational(9, 7), Rational(894427191, 200000000)}) {
      o.omega = omega;
      const LinearPhases phases(oscillator_as<Ball>(machine));
      for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
        for (const Rational& h : {Rational(3, 5), Rational(-2), Rational(11)}) {
          const Matrix closed = phases.flow({kind, 0}, Ball(h));
          const Matrix known = exponential(phases.drift({kind, 0}) * Ball(h).midpoint());
          for (Eigen::Index i = 0; i < closed.size(); ++i) {
            CHECK((closed.data()[i] - known.data()[i]).contains_zero());
            CHECK(is_narrow(closed.data()[i], 1e-20));
          }
        }
      }
    }
  }
  // At a resonance there is no closed form: m x'' + 4 x = cos 2 t.
  Machine machine = row_of_masses(1);
  auto& o = machine.oscillator;
  o.damping *= Rational(0);
  o.stiffness(0, 0) = Rational(4);
  o.omega = Rational(2);
  o.loads = {{0, 1, Rational(1), Rational(0)}};
  o.forward.sliding = {{Rational(0), Rational(2), Rational(0)}};
  const LinearPhases phases(oscillator_as<Ball>(machine));
  // x = t sin(2 t)/4 from rest, less what the friction does.
  const Matrix flow = phases.flow({PhaseKind::slip, 0}, Ball(3));
  CHECK(flow(0, 3).overlaps(Ball(3) * sin(Ball(6)) / Ball(4)));
  CHECK(is_narrow(flow(0, 3), 1e-30));
}

TEST_CASE(
    "a flow over an uncertain time contains those over its members, and none when it is too uncertain") {
  const LinearPhases phases(oscillator_as<Ball>(row_of_masses(3)));
  const Piece piece{PhaseKind::slip, 1};
  const auto check_contains = [](const LinearPhases& all, Piece of, const Rational& scale) {
    const auto from_1 = [&](int thousandths) { return Rational(scale * Rational(1000 + thousandths, 1000)); };
    // The whole, and what is kept of it beside it.
    for (const int width : {1, 100}) {
      const Ball h = Ball::from_interval(from_1(0), from_1(width));
      const Matrix wide = all.flow(of, h);
      const Vector from = Vector::Constant(wide.cols(), Ball(1));
      const Vector after = all.after(of, h, from);
      for (const int part : {0, width}) {
        const Matrix one = exponential(all.drift(of) * Ball(from_1(part)));
        for (Eigen::Index i = 0; i < one.size(); ++i) {
          CHECK((wide.data()[i] - one.data()[i]).contains_zero());
        }
        const Vector there = zeros::product(one, from);
        for (Eigen::Index i = 0; i < from.size(); ++i) {
          CHECK((after(i) - there(i)).contains_zero());
        }
      }
    }
  };
  check_contains(phases, piece, Rational(1));
  for (const Rational& l : {Rational(1, 1000000), Rational(1), Rational(1000)}) {
    const LinearPhases other(oscillator_as<Ball>(in_other_units(damped_O(), l, Rational(20))));
    check_contains(other, {PhaseKind::slip, 0}, Rational(1, 20));
    check_contains(other, {}, Rational(1, 20));
  }
  // So narrow that it is in closed form.
  const LinearPhases undamped(oscillator_as<Ball>(paper(O(), ur_of_O)));
  const Rational later = Rational(3) + Rational(1, 1000000000) / 1000000000;
  const Matrix narrow = undamped.flow({PhaseKind::slip, 0}, Ball::from_interval(Rational(3), later));
  for (const Rational& h : {Rational(3), later}) {
    const Matrix one = exponential(undamped.drift({PhaseKind::slip, 0}) * Ball(h));
    for (Eigen::Index i = 0; i < one.size(); ++i) {
      CHECK((narrow.data()[i] - one.data()[i]).contains_zero());
      CHECK(is_narrow(narrow.data()[i], 1e-16));
    }
  }
  CHECK_FALSE(phases.flow(piece, Ball::from_interval(Rational(0), Rational(9)))(0, 0).is_finite());
  CHECK_THROWS_AS((void)phases.flow({PhaseKind::slip, 3}, Ball(1)), InternalError);
}

TEST_CASE("a course has the values and derivatives of the flow, from both ends, within its bounds") {
  const LinearPhases phases(oscillator_as<Ball>(row_of_masses(3)));
  const Piece piece{PhaseKind::overshoot, 0};
  Vector X(6);
  X << Ball(0.4), Ball(-0.2), Ball(0.1), Ball(0.3), Ball(-0.7), Ball(1.1);
  const Vector w = phases.whole(X, Ball(0));
  const Ball T(3.3);
  const Vector end = zeros::product(phases.flow(piece, T), w);
  const Matrix& B = phases.drift(piece);
  const Vector row = phases.speed();
  const Watched g(phases, piece, InData<Matrix>(Matrix(w)), T, false);
  const Watched back(phases, piece, InData<Matrix>(Matrix(end)), T, true);
  const motion::DerivativeBounds bounds = g.bounds();
  for (const double s : {0.0, 0.01, 0.5, 1.0, 2.9, 3.3}) {
    Vector at = zeros::product(phases.flow(piece, Ball(s)), w);
    const std::array<Ball, 4> d = g.at(s);
    const std::array<Ball, 4> reversed = back.at(3.3 - s);
    const std::array<double, 4> guess = g.guess_at(s);
    for (std::size_t i = 0; i < 4; ++i) {
      Ball expected(0);
      for (Eigen::Index k = 0; k < row.size(); ++k) {
        add_product(expected, row(k), at(k));
      }
      CHECK(d[i].overlaps(expected));
      CHECK(is_narrow(d[i], 1e-28));
      CHECK(guess[i] == doctest::Approx(expected.approximate()).epsilon(1e-9));
      if (s == 0 || s == 3.3) {  // 3.3 - s is exact
        CHECK((i % 2 == 0 ? reversed[i] : Ball(-reversed[i])).overlaps(expected));
      }
      if (i == 3) {
        CHECK_FALSE((abs(expected) - bounds.third).is_positive());
      }
      at = Vector(zeros::product(B, at));
    }
    Ball fourth(0);
    for (Eigen::Index k = 0; k < row.size(); ++k) {
      add_product(fourth, row(k), at(k));
    }
    CHECK_FALSE((abs(fourth) - bounds.fourth).is_positive());
  }
  CHECK_FALSE(g.at(100).front().is_finite());
  // Divided by the distance to a zero: as by the distance, but where that is small.
  for (const std::size_t derivative : {0U, 1U}) {
    const AffineCourse from_zero(g, -1, InData<Ball>(g.at(Ball(0))[0]), {derivative, 0, 1});
    const Ball at_zero = g.at(Ball(0), derivative)[0];
    for (const double s : {0x1p-20, 0.01, 0.2, 2.5}) {
      const auto k = from_zero.quotient_at(s);
      const auto d = g.at(Ball(s), derivative);
      const Ball value = (at_zero - d[0]) / Ball(s), slope = (-d[1] - value) / Ball(s);
      if (derivative == 0 || s <= phases.watch(piece, false).length) {
        CHECK(k[0].overlaps(value));
        CHECK(k[1].overlaps(slope));
        CHECK(k[2].overlaps(Ball((-d[2] - Ball(2) * slope) / Ball(s))));
        CHECK(is_narrow(k[2], 1e-24));
      }
    }
  }
  // At few bits, in hardware.
  const WorkingPrecision scope(few_bits);
  const Watched quick(phases, piece, InData<Matrix>(Matrix(w)), T, false);
  for (const std::size_t derivative : {0U, 1U}) {
    for (const double s : {0.0, 0.01, 0.5, 2.9}) {
      const auto in_hardware = quick.at(Ball(s), derivative), known = g.at(Ball(s), derivative);
      for (std::size_t i = 0; i < known.size(); ++i) {
        CHECK(in_hardware[i].overlaps(known[i]));
        CHECK(is_narrow(in_hardware[i], 1e-11));
        CHECK_FALSE(is_narrow(in_hardware[i], 1e-30));
      }
      const auto quotient = quick.quotient_at(s, derivative), wanted = g.quotient_at(s, derivative);
      for (std::size_t i = 0; quotient && i < quotient->size(); ++i) {
        CHECK((*quotient)[i].overlaps((*wanted)[i]));
      }
    }
    CHECK(quick.bounds(derivative).third.approximate() ==
          doctest::Approx(g.bounds(derivative).third.approximate()).epsilon(1e-6));
  }
  const AffineCourse turned(g, -1, InData<Ball>(Ball(3)));
  CHECK(turned.at(0.5)[0].overlaps(Ball(3) - g.at(0.5)[0]));
  CHECK(turned.at(0.5)[1].overlaps(-g.at(0.5)[1]));
  CHECK(turned.guess_at(0.5)[0] == doctest::Approx(3 - g.guess_at(0.5)[0]));
}

TEST_CASE("the word of a motion that slips for ever, from one piece of the law to another, is S") {
  CHECK(word_of({{motion::PhaseKind::slip, 1}, {motion::PhaseKind::slip, 0}}) == "S");
}

TEST_CASE("without damping the orbit is the paper's, condition for condition") {
  const MachineOrbit orbit = settled(paper(O(), ur_of_O), start_of_O());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(word_of(orbit.pieces) == "OTS");
  CHECK(orbit.admissible.truth == Truth::proved);
  MachineGuess guess;
  for (const MachinePhase& phase : orbit.phases) {
    const double t = (orbit.load.approximate() / 0.6289) + phase.start.approximate();
    const Eigen::VectorXd X = phase.state.unaryExpr([](const Ball& x) { return x.approximate(); });
    guess.events.push_back({t, X, {phase.piece.kind}});
  }
  const words::WordOrbit same = words::prove_word_orbit({O(), ur_of_O}, guess);
  REQUIRE(same.existence.truth == Truth::proved);
  const std::vector<motion::Phase>& phases = same.orbit.motion.phases;
  REQUIRE(phases.size() == orbit.phases.size());
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const auto there = std::find_if(orbit.phases.begin(), orbit.phases.end(),
                                    [&](const MachinePhase& p) { return p.piece.kind == phases[i].kind; });
    CHECK(there->duration.overlaps(phases[i].duration));
    CHECK(there->state(2).overlaps(phases[i].Z(2)));
    CHECK(is_narrow(there->duration, 1e-20));
  }
  for (const motion::Condition& condition : same.orbit.conditions) {
    CHECK(condition.verdict.truth == Truth::proved);
  }
  REQUIRE(same.orbit.stability);
  CHECK(sqrt(same.orbit.stability->multipliers.front().squared_modulus())
            .overlaps(sqrt(orbit.stability->multipliers.front().squared_modulus())));
}

TEST_CASE("O with damping: its word stays stable, until it no longer crosses the belt") {
  for (const auto& [share, multiplier] : {std::pair{"1/2000", 0.9126},
                                          {"1/1000", 0.9105},
                                          {"1/500", 0.9067},
                                          {"3/1000", 0.9034},
                                          {"1/200", 0.8980},
                                          {"1/125", 0.8922}}) {
    CAPTURE(share);
    const MachineOrbit orbit = settled(paper(O(), ur_of_O, Rational(share)), start_of_O());
    CHECK(orbit.existence.truth == Truth::proved);
    CHECK(word_of(orbit.pieces) == "OTS");
    CHECK(orbit.admissible.truth == Truth::proved);
    CHECK(orbit.stability->kind == motion::StabilityKind::stable);
    CHECK(largest_multiplier(orbit) == doctest::Approx(multiplier).epsilon(1e-4));
  }
  const MachineGuess guess = settle(paper(O(), ur_of_O, Rational("1/125")), start_of_O()).guess;
  const MachineOrbit lost = prove_machine_orbit(paper(O(), ur_of_O, Rational("1/100")), guess);
  CHECK(lost.existence.truth == Truth::proved);
  CHECK(lost.admissible.truth == Truth::refuted);
  for (const motion::Condition& condition : lost.conditions) {
    CHECK((condition.verdict.truth == Truth::proved) == (condition.id != "crossing"));
  }
}

TEST_CASE("rows of masses on a belt without load: cycles, with their periods and multipliers") {
  for (const int n : {2, 3, 5}) {
    CAPTURE(n);
    Eigen::VectorXd X = Eigen::VectorXd::Zero(2 * n);
    X(2 * n - 1) = 0.4;
    const MachineOrbit orbit = settled(row_of_masses(n), X);
    CHECK(orbit.existence.truth == Truth::proved);
    CHECK(orbit.admissible.truth == Truth::proved);
    REQUIRE(orbit.stability);
    CHECK(orbit.stability->kind == motion::StabilityKind::stable);
    CHECK(is_narrow(orbit.period, 1e-20));
  }
}

TEST_CASE("what does not close, phase after phase, is not proved") {
  const Machine machine = row_of_masses(3);
  MachineGuess guess = settle(machine, Eigen::VectorXd::Constant(6, 0.1)).guess;
  REQUIRE(guess.events.size() > 2);
  REQUIRE(prove_machine_orbit(machine, guess).existence.truth == Truth::proved);
  guess.events.push_back(guess.events.back());
  const MachineOrbit orbit = prove_machine_orbit(machine, guess);
  CHECK(orbit.existence.truth == Truth::undecided);
  CHECK(orbit.existence.reason == "two of its phases cannot follow each other");
}

TEST_CASE("closed motions that do not obey the law are not admissible") {
  Eigen::VectorXd X = Eigen::VectorXd::Zero(4);
  X(3) = 0.4;
  const Machine machine = row_of_masses(2);
  const Settled found = settle(machine, X);
  REQUIRE(found.kind == attractors::Kind::periodic);
  REQUIRE(prove_machine_orbit(machine, found.guess).admissible.truth == Truth::proved);
  // That the friction changes at a higher relative velocity is overlooked.
  MachineGuess overlooked = found.guess;
  std::erase_if(overlooked.events, [](const MachineGuess::Event& event) { return event.begins.number > 0; });
  for (std::size_t i = 1; i < overlooked.events.size(); ++i) {
    if (overlooked.events[i].begins == overlooked.events[i - 1].begins) {
      overlooked.events.erase(overlooked.events.begin() + static_cast<std::ptrdiff_t>(i--));
    }
  }
  if (overlooked.events.front().begins == overlooked.events.back().begins) {
    overlooked.events.erase(overlooked.events.begin());
  }
  REQUIRE(overlooked.events.size() == 2);
  const MachineOrbit one_piece = prove_machine_orbit(machine, overlooked);
  CHECK(one_piece.admissible.truth != Truth::proved);
  CHECK_FALSE(one_piece.stability);
  // With more friction at rest on the other side the same motion closes, but sticks where it would cross.
  Machine sticky = paper(O(), ur_of_O);
  const MachineGuess guess = settle(sticky, start_of_O()).guess;
  sticky.oscillator.backward.at_rest += Rational(3, 100);
  const MachineOrbit sticks = prove_machine_orbit(sticky, guess);
  CHECK(sticks.existence.truth == Truth::proved);
  for (const motion::Condition& condition : sticks.conditions) {
    CHECK((condition.verdict.truth == Truth::refuted) == (condition.id == "crossing"));
  }
  CHECK(sticks.admissible.truth == Truth::refuted);
}

TEST_CASE(
    "O with damping over the load's frequency: round a fold, with the loss of its crossing on the way") {
  const Rational omega = O().omega, width = omega / 100;
  const auto at = [&](const Rational& value) {
    Machine machine = paper(O(), ur_of_O, Rational("1/500"));
    machine.oscillator.omega = value;
    return machine;
  };
  const Settled found = settle(at(omega), start_of_O());
  const MachineBranch branch = follow_machine_branch({at, omega - width, omega + width, omega, found.guess});
  REQUIRE(branch.existence.truth == Truth::proved);
  CHECK(branch.resolved());
  CHECK(branch.first.kind == branches::End::interval);
  CHECK(branch.last.kind == branches::End::interval);
  REQUIRE(branch.changes.size() == 2);
  const MachineChange& fold = branch.changes[0];
  CHECK(fold.kind == branches::ChangeKind::fold);
  const MachineChange& change = branch.changes[1];
  CHECK(change.kind == branches::ChangeKind::condition);
  CHECK(change.words == "the condition crossing is gained");
  CHECK(change.last - change.first <= 2 * width * Rational(branch_resolution));
  // There are two motions before the fold.
  CHECK(fold.first < change.first);
  const auto beside = std::ranges::find_if(branch.samples, &MachineSample::before_fold);
  REQUIRE(beside != branch.samples.begin());
  const MachineSample &above = *std::prev(beside), &below = *beside;
  CHECK(above.after_fold);
  CHECK(fold.first == below.value);
  CHECK_FALSE(above.orbit.phases[0].duration.overlaps(below.orbit.phases[0].duration));
  for (const MachineSample& s : branch.samples) {
    CHECK(s.orbit.existence.truth == Truth::proved);
    CHECK(s.value >= below.value);
  }
  // On both sides, at machines of their own, simulations agree: it stays, or it leaves.
  for (const auto& [value, stays] : {std::pair(Rational(change.last + width / 50), true),
                                     std::pair(Rational(change.first - width / 50), false)}) {
    const auto sample = std::ranges::min_element(
        beside, branch.samples.end(), {},
        [&](const MachineSample& s) { return std::abs(Rational(s.value - value).get_d()); });
    const Machine machine = at(sample->value);
    const MachineGuess guess = guess_of(sample->orbit, machine);
    const Settled end = settle(machine, start_at_phase_0(machine, guess));
    CHECK((end.kind == attractors::Kind::periodic && word_of(sample->orbit.pieces) == "OTS" &&
           end.guess.events.size() == 3) == stays);
  }
  const auto other_way = [&](const Rational& from, const Rational& to, const Rational& start) {
    return follow_machine_branch({at, from, to, start, found.guess});
  };
  CHECK_THROWS_AS((void)other_way(omega, omega, omega), UsageError);
  CHECK_THROWS_AS((void)other_way(omega, omega + width, omega - width), UsageError);
  CHECK_THROWS_AS((void)other_way(-omega, omega + width, omega), DomainError);
}

TEST_CASE("a branch that folds twice has a jump, and one of a doubled period ends where it doubles") {
  // One mass under two harmonics: between two folds there are three motions.
  Machine two = row_of_masses(1);
  two.oscillator.stiffness(0, 0) = 1;
  two.oscillator.damping(0, 0) = Rational("1/50");
  two.oscillator.V = Rational("3/5");
  two.oscillator.forward =
      two.oscillator.backward = {Rational("4/5"), {{Rational(0), Rational("1/2"), Rational(0)}}};
  two.oscillator.loads = {{0, 1, Rational("2/5"), Rational(0)}, {0, 3, Rational("1/5"), Rational("1/10")}};
  const auto at = [&](const Rational& omega) {
    Machine machine = two;
    machine.oscillator.omega = omega;
    return machine;
  };
  const Rational start("7/10");
  const MachineGuess guess = settle(at(start), Eigen::VectorXd::Zero(2)).guess;
  const MachineBranch branch = follow_machine_branch({at, Rational("6/10"), Rational("8/10"), start, guess});
  std::vector<double> folds;
  for (const MachineChange& change : branch.changes) {
    if (change.kind == branches::ChangeKind::fold) {
      folds.push_back(change.first.get_d());
    }
  }
  REQUIRE(folds.size() == 3);
  for (std::size_t k = 0; k + 1 < branch.samples.size(); ++k) {
    const MachineSample &a = branch.samples[k], &b = branch.samples[k + 1];
    CHECK((a.value != b.value || a.before_fold || b.before_fold || a.after_fold || b.after_fold));
  }
  CHECK(branch.resolved());
}

TEST_CASE("orbits of a word are found by random starts and near a state, or what is met is said") {
  const Machine machine = paper(O(), ur_of_O, Rational("1/500"));
  const MachineWord word{machine, words::Word::parse("OTS"), {}, {}};
  const MachineWordOrbits found = find_word_orbits(word);
  REQUIRE(found.orbits.size() == 1);
  CHECK(found.seen.empty());
  MachineWord near = word;
  near.near = start_of_O();
  const MachineWordOrbits same = find_word_orbits(near);
  REQUIRE(same.orbits.size() == 1);
  CHECK(same.orbits[0].period.overlaps(found.orbits[0].period));
  CHECK(same.orbits[0].phases[0].duration.overlaps(found.orbits[0].phases[0].duration));
  for (MachineWord none : {word, near}) {
    none.periods = 2;
    CHECK(find_word_orbits(none).orbits.empty());
    CHECK(find_word_orbits(none).seen.find("OTS with the period 1") != std::string::npos);
  }
  const Machine row = row_of_masses(3);
  const MachineWordOrbits cycle = find_word_orbits({row, words::Word::parse("ST"), {}, {}});
  REQUIRE(cycle.orbits.size() == 2);  // two cycles, not one twice
  CHECK_FALSE(cycle.orbits[0].period.overlaps(cycle.orbits[1].period));
  CHECK(word_of(cycle.orbits[0].pieces) == "ST");
  CHECK(find_word_orbits({row, words::Word::parse("OS"), {}, {}}).seen.find("ST") != std::string::npos);
  CHECK_THROWS_AS((void)over_periods(row, Eigen::VectorXd::Zero(6), 1), UsageError);
}

TEST_CASE("steady sliding: where it is, when it is stable, and where that is lost") {
  // One mass: K x = f(V), eigenvalues (-(c + d) +- sqrt((c + d)² - 4 k m))/(2 m), d the slope.
  Machine machine = row_of_masses(1);
  auto& o = machine.oscillator;
  o.damping(0, 0) = Rational("1/5");  // V = 1/2 is an end of a piece
  const SteadySliding corner = steady_sliding(machine);
  CHECK(corner.existence.truth == Truth::proved);
  CHECK(corner.stability == motion::StabilityKind::undecided);
  CHECK(corner.reason == "the relative velocity 0.5 is where two pieces of the friction law meet");
  o.V = 1;  // friction 3/2 - (1/2)/4 = 11/8, slope -1/4
  SteadySliding state = steady_sliding(machine);
  CHECK(state.piece == Piece{motion::PhaseKind::slip, 1});
  CHECK(state.friction.contains(Rational("11/8")));
  CHECK((state.x(0) * Ball(o.stiffness(0, 0)) - state.friction).contains_zero());
  CHECK(state.stability == motion::StabilityKind::unstable);
  CHECK(state.eigenvalues.at(0).re.contains(Rational("1/40")));
  o.damping(0, 0) = Rational("3/10");
  CHECK(steady_sliding(machine).stability == motion::StabilityKind::stable);
  // The other way the mass is pulled, and beyond the belt's velocity nothing changes but the sign.
  o.V = -1;
  state = steady_sliding(machine);
  CHECK(state.piece == Piece{motion::PhaseKind::overshoot, 1});
  CHECK(state.x(0).is_negative());
  CHECK(state.stability == motion::StabilityKind::stable);
  o.V = 0;
  CHECK(steady_sliding(machine).existence.truth == Truth::refuted);
  o.V = 1;
  o.loads = {{0, 1, Rational(1), Rational(0)}};
  o.omega = 1;
  CHECK(steady_sliding(machine).existence.truth == Truth::refuted);
  // Loads that take each other away, or of no amplitude, do not vary.
  o.loads.push_back({0, 1, Rational(-1), Rational(0)});
  CHECK(steady_sliding(machine).existence.truth == Truth::proved);
  o.loads[1].sine = 1;
  CHECK(steady_sliding(machine).existence.truth == Truth::refuted);
  o.loads = {{0, 1, Rational(0), Rational(0)}, {0, 0, Rational(2), Rational(0)}};
  CHECK((steady_sliding(machine).x(0) * Ball(o.stiffness(0, 0)) - Ball(Rational("27/8"))).contains_zero());
  o.loads.clear();
  o.stiffness(0, 0) = 0;
  CHECK(steady_sliding(machine).existence.truth == Truth::undecided);

  // Along the damping it is lost at c = 1/4, with the frequency sqrt(k/m); along V at the ends of pieces.
  const auto damped = [](const Rational& c) {
    Machine one = row_of_masses(1);
    one.oscillator.V = 1;
    one.oscillator.damping(0, 0) = c;
    return one;
  };
  const SteadyAlong along = steady_sliding_along(damped, 0, 1);
  REQUIRE(along.changes.size() == 1);
  CHECK(along.changes[0].first < Rational("1/4"));
  CHECK(along.changes[0].last > Rational("1/4"));
  CHECK(along.changes[0].last - along.changes[0].first < Rational("1/100000000"));
  CHECK_FALSE(along.changes[0].is_lost);
  CHECK_FALSE(along.changes[0].is_corner);
  CHECK(std::abs(along.changes[0].frequency.value().approximate() -
                 std::sqrt(row_of_masses(1).oscillator.stiffness(0, 0).get_d())) < 1e-6);
  const auto faster = [](const Rational& V) {
    Machine one = row_of_masses(1);
    one.oscillator.V = V;
    one.oscillator.damping(0, 0) = Rational("1/5");
    return one;
  };
  const SteadyAlong ends = steady_sliding_along(faster, 1, 3);
  REQUIRE(ends.changes.size() == 1);
  CHECK(ends.changes[0].is_corner);
  CHECK((ends.changes[0].first < 2 && ends.changes[0].last > 2));
  CHECK_THROWS_AS((void)steady_sliding_along(faster, 3, 1), UsageError);
  // Several masses: a simulation from beside it comes back, or leaves.
  Machine row = row_of_masses(3);
  row.oscillator.V = 3;
  const SteadySliding still = steady_sliding(row);
  REQUIRE(still.stability == motion::StabilityKind::stable);
  Eigen::VectorXd X = Eigen::VectorXd::Zero(6);
  for (Eigen::Index i = 0; i < 3; ++i) {
    X(i) = still.x(i).approximate() + 1e-3;
  }
  const Settled end = settle(row, X);
  CHECK(end.kind == attractors::Kind::slides);
}

TEST_CASE("what is no machine is refused in a sentence") {
  const auto refusal = [](auto change) {
    Machine machine = row_of_masses(2);
    change(machine.oscillator);
    try {
      require_machine(machine);
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal([](auto&) {}).empty());
  CHECK(refusal([](auto& o) { o.masses[1] = 0; }).find("mass 2 = 0") == 0);
  CHECK(refusal([](auto& o) { o.masses.clear(); }).find("the machine") == 0);
  CHECK(refusal([](auto& o) { o.stiffness(0, 1) = 3; }).find("K(2, 1) = -10") == 0);
  CHECK(refusal([](auto& o) { o.rubbing = 2; }).find("the mass on the belt = 3") == 0);
  CHECK(refusal([](auto& o) { o.forward.sliding[1].from = 0; }).find("a relative velocity") == 0);
  CHECK(refusal([](auto& o) { o.forward.sliding[1].force = 1; }).find("the sliding friction = 1") == 0);
  CHECK(refusal([](auto& o) { o.backward.sliding.clear(); }).find("the sliding friction = nothing") == 0);
  CHECK(refusal([](auto& o) { o.backward.at_rest = 1; }).find("the sliding friction at 0 = 2") == 0);
  CHECK(refusal([](auto& o) { o.loads.push_back({5, 1, 1, 0}); }).find("the mass of a load = 6") == 0);
  CHECK(refusal([](auto& o) { o.loads.push_back({0, 1, 1, 0}); }).find("the load's frequency = 0") == 0);
  CHECK_THROWS_AS((void)settle(row_of_masses(2), Eigen::VectorXd::Zero(3)), DomainError);
  CHECK_THROWS_AS((void)prove_machine_orbit(row_of_masses(2), {}), DomainError);
}
