// Machines of any number of masses: the linear phases against the paper's closed forms, courses against
// flows, chains against the paper's, and orbits with their multipliers.
#include <doctest/doctest.h>

#include <random>

#include "core/error.hpp"
#include "numeric/machines/linear_course.hpp"
#include "numeric/machines/settle.hpp"
#include "numeric/words/oscillator_chain.hpp"
#include "numeric/words/word_orbit.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "tests/numeric/examples.hpp"

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
    "a flow over an uncertain time contains those over its members, and none when it is too uncertain") {
  const LinearPhases phases(oscillator_as<Ball>(row_of_masses(3)));
  const Piece piece{PhaseKind::slip, 1};
  const Matrix wide = phases.flow(piece, Ball::from_interval(Rational("1"), Rational("1001/1000")));
  for (const char * member : {"1", "10004/10000", "1001/1000"}) {
    const Matrix one = phases.flow(piece, Ball(Rational(member)));
    for (Eigen::Index i = 0; i < one.size(); ++i) {
      CHECK(wide.data()[i].overlaps(one.data()[i]));
      CHECK((wide.data()[i] - one.data()[i]).contains_zero());
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
  const Watched g(phases, piece, w, T, false);
  const Watched back(phases, piece, end, T, true);
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
  const AffineCourse turned(g, -1, Ball(3));
  CHECK(turned.at(0.5)[0].overlaps(Ball(3) - g.at(0.5)[0]));
  CHECK(turned.at(0.5)[1].overlaps(-g.at(0.5)[1]));
  CHECK(turned.guess_at(0.5)[0] == doctest::Approx(3 - g.guess_at(0.5)[0]));
}

TEST_CASE("chains of a machine are the paper's for its oscillator") {
  const ExactParameters data = O();
  const std::vector<PhaseKind> kinds{PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick};
  const words::OscillatorChain closed({data, ur_of_O, kinds, 1});
  const MachineChain linear({paper(data, ur_of_O), {{kinds[0], 0}, {kinds[1], 0}, {kinds[2], 0}}, 1});
  const model::Vector2<Ball>& d0 = closed.oscillator().d0;
  words::Nodes z, x;
  for (int i = 0; i < 3; ++i) {
    z.push_back(words::node(Ball(0.1 + 2.5 * i), Ball(0.4 * i), Ball(0.3 - i), Ball(0.2)));
    x.push_back(z.back());
    x.back()(1) += d0(0);
    x.back()(2) += d0(1);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const words::Node F = closed.conditions(z, i), G = linear.conditions(x, i);
    const words::Link a = closed.link(z, i), b = linear.link(x, i);
    for (Eigen::Index k = 0; k < 4; ++k) {
      CHECK(F(k).overlaps(G(k)));
      CHECK(is_narrow(G(k), 1e-28));
      CHECK(a.end_velocity(k).overlaps(b.end_velocity(k)));
      for (Eigen::Index l = 0; l < 4; ++l) {
        CHECK(a.M(k, l).overlaps(b.M(k, l)));
      }
    }
    CHECK(a.rate.overlaps(b.rate));
  }
}

TEST_CASE("without damping the orbit is the paper's, condition for condition") {
  const MachineOrbit orbit = settled(paper(O(), ur_of_O), start_of_O());
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(word_of(orbit.pieces) == "OTS");
  CHECK(orbit.admissible.truth == Truth::proved);
  words::Guess guess;
  for (const MachinePhase& phase : orbit.phases) {
    const double t = (orbit.load.approximate() / 0.6289) + phase.start.approximate();
    guess.events.push_back({t, phase.state(0).approximate(), phase.state(1).approximate(),
                            phase.state(2).approximate(), phase.piece.kind});
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

TEST_CASE("what is no machine is refused in a sentence") {
  const auto refusal = [](auto change) {
    Machine machine = row_of_masses(2);
    change(machine.oscillator);
    try {
      require_machine(machine, true);
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
  CHECK(refusal([](auto& o) { o.backward.at_rest = 2; }).find("the sliding friction at 0 = 2") == 0);
  CHECK(refusal([](auto& o) { o.loads.push_back({5, 1, 1, 0}); }).find("the mass of a load = 6") == 0);
  CHECK(refusal([](auto& o) { o.loads.push_back({0, 1, 1, 0}); }).find("the load's frequency = 0") == 0);
  CHECK_THROWS_AS((void)settle(row_of_masses(2), Eigen::VectorXd::Zero(3)), DomainError);
  CHECK_THROWS_AS((void)prove_machine_orbit(row_of_masses(2), {}), DomainError);
}
