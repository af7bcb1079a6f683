// Machines on smooth laws of friction: enclosures of a phase against motions inside them and against more
// bits, cycles against their piecewise linear neighbours, steady sliding against closed forms.
#include <doctest/doctest.h>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <random>

#include "core/error.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/attractors/steady_sliding.hpp"
#include "numeric/machines/orbits/judge.hpp"
#include "numeric/machines/orbits/motions_over_data.hpp"
#include "numeric/machines/phases/numbers_in_data.hpp"
#include "numeric/machines/phases/smooth_phase.hpp"
#include "numeric/zeros/linear_solve.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::machines;

namespace {

// One mass on a spring with a dashpot c on a belt, friction between 1 and 1/2.
Machine one_mass(const Rational& c, const Rational& V, model::Fall fall = model::Fall::exponential,
                 const Rational& at_rest = 1) {
  Machine machine;
  auto& o = machine.oscillator;
  o.masses = {Rational(1)};
  o.stiffness = model::MatrixX<Rational>::Constant(1, 1, Rational(1));
  o.damping = model::MatrixX<Rational>::Constant(1, 1, c);
  o.rubbing = 0;
  o.V = V;
  o.forward = smooth_law(at_rest, {fall, Rational(1), Rational("1/2"), Rational("1/2"), Rational(0)});
  o.backward = o.forward;
  return machine;
}

// Two masses, a load, and a law with a viscous part.
Machine two_masses(model::Fall fall) {
  Machine machine = one_mass(Rational("1/10"), Rational("3/2"), fall);
  auto& o = machine.oscillator;
  o.masses.emplace_back(2);
  o.stiffness = o.damping = model::MatrixX<Rational>::Constant(2, 2, Rational(0));
  o.stiffness << Rational(3), Rational(-1), Rational(-1), Rational(1);
  o.damping << Rational("1/10"), Rational(0), Rational(0), Rational("1/20");
  o.rubbing = 1;
  o.forward =
      smooth_law(Rational(2), {fall, Rational(1), Rational("1/2"), Rational("1/2"), Rational("1/10")});
  o.backward = o.forward;
  o.loads = {{0, 1, Rational("1/2"), Rational("1/3")}};
  o.omega = 2;
  return machine;
}

using State = std::vector<double>;

// x, x' after a time, by Odeint on the equation of motion of a slip or, backwards, to where it was.
State integrated(const Machine& machine, const State& X, double theta, double T) {
  namespace odeint = boost::numeric::odeint;
  const auto o = oscillator_as<double>(machine);
  const auto rate = [&](const State& w, State& dw, double t) {
    const std::size_t n = o.size();
    for (std::size_t i = 0; i < n; ++i) {
      double force = i == o.rubbing ? o.forward.smooth->force(o.V - w[n + i]) : 0;
      for (const auto& load : o.loads) {
        const double psi = theta + load.k * o.omega * t;
        force += load.mass == i ? load.cosine * std::cos(psi) + load.sine * std::sin(psi) : 0;
      }
      for (std::size_t k = 0; k < n; ++k) {
        const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(k);
        force -= o.stiffness(a, b) * w[k] + o.damping(a, b) * w[n + k];
      }
      dw[i] = w[n + i];
      dw[n + i] = force / o.masses[i];
    }
  };
  State w = X;
  odeint::integrate_adaptive(odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_dopri5<State>()), rate,
                             w, 0.0, T, T < 0 ? -1e-3 : 1e-3);
  return w;
}

Vector in_balls(const State& X) {
  Vector v(static_cast<Eigen::Index>(X.size()));
  for (std::size_t i = 0; i < X.size(); ++i) {
    v(static_cast<Eigen::Index>(i)) = Ball(X[i]);
  }
  return v;
}

// Whether a number that is known up to some 1e-10 lies in the ball.
bool holds(const Ball& ball, double x) {
  return ball.overlaps(Ball(x) + Ball::hull(Ball(-1e-10), Ball(1e-10)));
}

}  // namespace

TEST_CASE("a smooth phase from a box encloses the motions from all of it, both ways") {
  std::mt19937_64 random(7);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  for (const model::Fall fall : {model::Fall::exponential, model::Fall::hyperbolic}) {
    const Machine machine = two_masses(fall);
    const LinearPhases phases(oscillator_as<Ball>(machine));
    const State middle{0.2, 0.5, -0.1, 0.3};
    constexpr double width = 1e-3, theta = 0.4;
    const Ball wide = Ball::hull(Ball(-width), Ball(width));
    for (const bool reversed : {false, true}) {
      const double T = reversed ? 0.7 : 1.1;
      Vector box = in_balls(middle);
      for (Eigen::Index i = 0; i < 4; ++i) {
        box(i) += wide;
      }
      const SmoothPhase phase(phases, 1, phases.whole(box, Ball(theta)), Ball(T), reversed, true);
      REQUIRE(!phase.steps().empty());
      const Vector end = phase.end();
      const Matrix D = phase.derivative();
      for (int sample = 0; sample < 30; ++sample) {
        State X = middle;
        for (double& x : X) {
          x += width * (sample < 15 ? (share() > 0 ? 1 : -1) : share());
        }
        const State reached = integrated(machine, X, theta, reversed ? -T : T);
        for (std::size_t i = 0; i < 4; ++i) {
          CHECK(holds(end(static_cast<Eigen::Index>(i)), reached[i]));
        }
        // The derivative at this start, by differences.
        constexpr double step = 1e-5;
        for (std::size_t k = 0; k < 4; ++k) {
          State up = X, down = X;
          up[k] += step;
          down[k] -= step;
          const State a = integrated(machine, up, theta, reversed ? -T : T);
          const State b = integrated(machine, down, theta, reversed ? -T : T);
          for (std::size_t i = 0; i < 4; ++i) {
            const Ball near = Ball((a[i] - b[i]) / (2 * step)) + Ball::hull(Ball(-1e-6), Ball(1e-6));
            CHECK(D(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)).overlaps(near));
          }
        }
      }
      // It is no wider than what motions of that width become, by some factor.
      for (Eigen::Index i = 0; i < 4; ++i) {
        CHECK(end(i).radius().approximate() < 30 * width);
      }
    }
  }
}

TEST_CASE("with few bits a smooth phase is wide, and holds what many bits find") {
  for (const model::Fall fall : {model::Fall::exponential, model::Fall::hyperbolic}) {
    const Machine machine = two_masses(fall);
    const auto at = [&](long bits) {
      const WorkingPrecision scope(bits);
      const LinearPhases phases(oscillator_as<Ball>(machine));
      const SmoothPhase phase(phases, 1, phases.whole(in_balls({0.2, 0.5, -0.1, 0.3}), Ball(0.4)), Ball(1.5),
                              false, true);
      return std::pair(phase.end(), phase.derivative());
    };
    const auto [exact, exact_derivative] = at(400);
    for (const long bits : {16L, 24L, 40L, 80L, 130L}) {
      const auto [end, derivative] = at(bits);
      for (Eigen::Index i = 0; i < 4; ++i) {
        CHECK(end(i).contains(exact(i)));
        CHECK((bits < 24 || end(i).radius().approximate() < std::exp2(-static_cast<double>(bits) + 20)));
        for (Eigen::Index k = 0; k < 4; ++k) {
          CHECK(derivative(i, k).contains(exact_derivative(i, k)));
        }
      }
    }
  }
}

TEST_CASE("the last coefficient of a step holds that of all motions on the step") {
  for (const model::Fall fall : {model::Fall::exponential, model::Fall::hyperbolic}) {
    const Machine machine = two_masses(fall);
    const State X{0.2, 0.5, -0.1, 0.3};
    const auto follow = [&](long bits, const Vector& w, const Ball& T) {
      const WorkingPrecision scope(bits);
      const LinearPhases phases(oscillator_as<Ball>(machine));
      return std::pair(SmoothPhase(phases, 1, w, T, false, true).steps(),
                       std::pair(SmoothPhase(phases, 1, w, T, false, true).end(),
                                 SmoothPhase(phases, 1, w, T, false, true).derivative()));
    };
    const WorkingPrecision scope(200);
    const LinearPhases phases(oscillator_as<Ball>(machine));
    const Vector start = phases.whole(in_balls(X), Ball(0.4));
    const auto [steps, at_end] = follow(24, start, Ball(1.5));
    REQUIRE(steps.size() > 1);
    const SmoothPhase::Step& step = steps.front();
    const std::size_t last = step.w.size() - 1;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Ball s(share * step.length);
      const auto [w, D] =
          share == 0 ? std::pair(start, Matrix(Matrix::Identity(4, 4))) : follow(200, start, s).second;
      const std::vector<SmoothPhase::Step> from_there = follow(200, w, Ball(1.0)).first;
      for (Eigen::Index i = 0; i < w.size(); ++i) {
        CHECK(step.w[last](i).contains(from_there.front().w[last](i)));
      }
      const Matrix derivative = zeros::product(from_there.front().derivative[last], D);
      for (Eigen::Index i = 0; i < 4; ++i) {
        for (Eigen::Index k = 0; k < 4; ++k) {
          CHECK(step.derivative[last](i, k).contains(derivative(i, k)));
        }
      }
    }
  }
}

TEST_CASE("a course on a smooth law has the values and derivatives of the motion, within its bounds") {
  const Machine machine = two_masses(model::Fall::hyperbolic);
  const LinearPhases phases(oscillator_as<Ball>(machine));
  const State X{0.2, 0.5, -0.1, 0.3};
  const Piece slip{motion::PhaseKind::slip, 0};
  const Watched f(phases, slip, InData<Matrix>(Matrix(phases.whole(in_balls(X), Ball(0.4)))), Ball(2.0),
                  false);
  const motion::DerivativeBounds bounds = f.bounds(), of_rate = f.bounds(1);
  for (double s = 0; s <= 2; s += 0.125) {
    const auto d = f.at(Ball(s)), rate = f.at(Ball(s), 1);
    CHECK(holds(d[0], s == 0 ? X[3] : integrated(machine, X, 0.4, s)[3]));
    const auto guess = f.guess_at(s);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(guess[i] == doctest::Approx(d[i].approximate()).epsilon(1e-9));
      CHECK((i == 3 || d[i + 1].overlaps(rate[i])));
    }
    CHECK(!(abs(d[3]) - bounds.third).is_positive());
    CHECK(!(abs(rate[3]) - bounds.fourth).is_positive());
    CHECK(!(abs(rate[3]) - of_rate.third).is_positive());
    if (s + 0.125 <= 2) {
      const auto next = f.at(Ball(s + 0x1p-20), 1);
      CHECK(d[1].approximate() + d[2].approximate() * 0x1p-20 ==
            doctest::Approx(next[0].approximate()).epsilon(1e-9));
    }
  }
}

TEST_CASE("the cycle on Stribeck's smooth law is proved, and pieces come near it") {
  const Machine machine = one_mass(Rational("1/10"), Rational("3/2"));
  Eigen::VectorXd X(2);
  X << 2, 1;
  const Settled found = settle(machine, X);
  REQUIRE(found.kind == attractors::Kind::periodic);
  const MachineOrbit orbit = prove_machine_orbit(machine, found.guess);
  REQUIRE(orbit.existence.truth == Truth::proved);
  CHECK(orbit.admissible.truth == Truth::proved);
  CHECK(word_of(orbit.pieces, true) == "S1T");
  REQUIRE(orbit.stability);
  CHECK(orbit.stability->kind == motion::StabilityKind::stable);
  // A stick forgets: one multiplier, 0.
  REQUIRE(orbit.stability->multipliers.size() == 1);
  CHECK(orbit.stability->multipliers[0].re.contains_zero());
  CHECK(orbit.period.radius().approximate() < 1e-20);
  // It is where the motion on the pieces was seen, not just anywhere.
  CHECK(distance(guess_of(orbit, machine), found.guess) < 0.01);
  MachineGuess other = found.guess;
  other.events[0].X *= 1.2;
  CHECK(distance(guess_of(orbit, machine), other) > 0.1);
  // As the motion leaves the belt, so it does: slowly, for the friction does not drop.
  CHECK(std::ranges::any_of(orbit.conditions, [](const auto& c) { return c.id == "leaves"; }));
  // The cycle by Odeint: r = 1 where the slip begins, from x = 1 - c V.
  const State slip_end = integrated(machine, {0.85, 1.5}, 0, orbit.phases[0].duration.approximate());
  REQUIRE(orbit.phases[0].piece.kind == motion::PhaseKind::slip);
  CHECK(orbit.phases[0].state(0).contains(Rational("17/20")));
  CHECK(slip_end[0] == doctest::Approx(orbit.phases[1].state(0).approximate()).epsilon(1e-10));
  CHECK(slip_end[1] == doctest::Approx(1.5).epsilon(1e-10));
  // On pieces the cycle is another one, near it, and nearer with more of them.
  Machine pieces = machine;
  pieces.oscillator.forward.smooth.reset();
  pieces.oscillator.backward.smooth.reset();
  const MachineOrbit near = prove_machine_orbit(pieces, settle(pieces, X).guess);
  REQUIRE(near.existence.truth == Truth::proved);
  CHECK(near.admissible.truth == Truth::proved);
  CHECK(!near.period.overlaps(orbit.period));
  CHECK(near.period.approximate() == doctest::Approx(orbit.period.approximate()).epsilon(1e-4));
}

namespace {

// Two masses whose law, belt, mass and load vary by the share.
Machine varied(model::Fall fall, const Values& values) {
  Machine machine = two_masses(fall);
  auto& o = machine.oscillator;
  const Rational &first = values[0], &second = values[1];
  o.forward =
      smooth_law(Rational(2), {fall, Rational(first), Rational(first * Rational("1/2")),
                               Rational(second * Rational("1/2")), Rational(second * Rational("1/10"))});
  o.backward = o.forward;
  o.V *= second;
  o.masses[1] *= first;
  o.damping(1, 1) *= second;
  o.loads[0].cosine *= first;
  return machine;
}

}  // namespace

TEST_CASE("a smooth phase over data contains each one, and leaves out what is of the fourth order") {
  for (const bool reversed : {false, true}) {
    const model::Fall fall = reversed ? model::Fall::hyperbolic : model::Fall::exponential;
    CAPTURE(reversed);
    std::vector<double> left_out;
    for (const Rational& share : {Rational(1, 64), Rational(1, 128)}) {
      const NumbersInData numbers([&](const Values& values) { return varied(fall, values); },
                                  Values(2, 1 - share), Values(2, 1 + share));
      REQUIRE(numbers.why_not().empty());
      const LinearPhases all(numbers.over({Values(2, 1), Values(2, share)}));
      // Where it begins and how long it lasts varies, too.
      const auto along = [&](double constant, double first, double second) {
        InData<Ball> f((Ball(constant)));
        f.c.resize(monomials(2));
        f.c[place_of(1)] = Ball(first) * Ball(share);
        f.c[place_of(2)] = Ball(second) * Ball(share);
        return f;
      };
      model::MatrixX<InData<Ball>> X(4, 1);
      X << along(0.2, 0.3, 0), along(0.5, 0, -0.2), along(-0.1, 0.1, 0.1), along(0.3, 0.2, 0);
      const InData<Ball> T = along(1.4, 0.5, -0.3), theta = along(0.4, 0, 0);
      const SmoothPhaseOf<InData<Ball>> phase(all, 1, entries(all.whole(together(X), theta)), T, reversed,
                                              true);
      REQUIRE(phase.steps().size() > 1);
      const InData<Matrix> end = together(phase.end()), D = together(phase.derivative());
      const std::vector<Rational> places{Rational(-1), Rational(-1, 3), Rational(0), Rational(1, 2),
                                         Rational(1)};
      for (const Rational& s0 : places) {
        for (const Rational& s1 : places) {
          const std::vector<Ball> s{Ball(s0), Ball(s1)};
          const Machine machine = varied(fall, {1 + share * s0, 1 + share * s1});
          const LinearPhases one(oscillator_as<Ball>(machine));
          Vector state(4);
          for (Eigen::Index i = 0; i < 4; ++i) {
            state(i) = X(i).at(s);
          }
          const SmoothPhase there(one, 1, one.whole(state, Ball(0.4)), T.at(s), reversed, true);
          const Vector reached = there.end();
          const Matrix derivative = there.derivative();
          for (Eigen::Index i = 0; i < 4; ++i) {
            CHECK(end.at(s)(i, 0).contains(reached(i)));
            for (Eigen::Index k = 0; k < 4; ++k) {
              CHECK(D.at(s)(i, k).contains(derivative(i, k)));
            }
          }
        }
      }
      left_out.push_back(zeros::norm(end.rest).approximate());
    }
    // Half as wide, a sixteenth of it.
    CHECK(left_out[0] > 10 * left_out[1]);
    CHECK(left_out[0] < 1e-4);
  }
}

namespace {

// One mass at these velocities of the belt and of the law's fall.
Machine one_mass_at(const Values& values) {
  Machine machine = one_mass(Rational("1/10"), values[0]);
  machine.oscillator.forward = smooth_law(
      Rational(1), {model::Fall::exponential, Rational(1), Rational("1/2"), values[1], Rational(0)});
  machine.oscillator.backward = machine.oscillator.forward;
  return machine;
}
MotionAt cycle_at(const Values& values) {
  Eigen::VectorXd X(2);
  X << 2, 1;
  return {values, settle(one_mass_at(values), X).guess};
}

}  // namespace

TEST_CASE("a cycle on a smooth law is proved over an interval") {
  const auto at = [](const Rational& V) { return one_mass_at({V, Rational("1/2")}); };
  std::vector<MotionAt> motions;
  for (const Rational& V : {Rational("74/50"), Rational("76/50")}) {
    motions.push_back({{V}, cycle_at({V, Rational("1/2")}).guess});
  }
  const auto joints = joints_between(at, motions, branches::State::stable);
  REQUIRE(joints.size() == 1);
  CAPTURE(joints[0].existence.reason);
  CHECK(joints[0].existence.truth == Truth::proved);
  CHECK(joints[0].state.truth == Truth::proved);
  CHECK(joints_between(at, motions, branches::State::unstable)[0].state.truth != Truth::proved);
}

TEST_CASE("a cycle on a smooth law is proved over a box of its data") {
  const Values middle{Rational("3/2"), Rational("1/2")};
  const DataBox box{
      one_mass_at, {Rational("149/100"), Rational("99/200")}, {Rational("151/100"), Rational("101/200")}};
  const auto parts = motions_over(box, {cycle_at(middle)}, {8, 40});
  for (const PartOfBox& part : parts) {
    CAPTURE(part.existence.reason);
    CAPTURE(part.motions.names);
    CHECK(part.existence.truth == Truth::proved);
    CHECK(part.motions.state == branches::State::stable);
  }
  CHECK(parts.size() <= 16);
}

TEST_CASE("a closed motion on a smooth law that does not obey it is not admissible") {
  // The second of two masses on a belt, both on springs, with a load on it.
  const auto at = [](const Rational& frequency) {
    Machine machine = two_masses(model::Fall::exponential);
    auto& o = machine.oscillator;
    o.masses = {Rational("5/2"), Rational("4/5")};
    o.stiffness << Rational(1650), Rational(-450), Rational(-450), Rational(450);
    o.damping << Rational("3/5"), Rational(0), Rational(0), Rational(0);
    o.V = Rational("1/20");
    o.forward = smooth_law(Rational("27/2"), {model::Fall::exponential, Rational(9), Rational(6),
                                              Rational("1/10"), Rational(0)});
    o.backward = o.forward;
    o.loads = {{1, 1, Rational(12), Rational(0)}};
    o.omega = frequency;
    machine.in_turns = true;
    return machine;
  };
  const Settled found = settle(at(Rational("359/100")), Eigen::VectorXd::Zero(4));
  const MachineOrbit orbit = prove_machine_orbit(at(Rational("359/100")), found.guess);
  CHECK(orbit.admissible.truth == Truth::proved);
  CHECK(word_of(orbit.pieces) == "OTS");
  // A little slower and the stick would have broken away before it ends.
  const MachineOrbit slower = prove_machine_orbit(at(Rational("358/100")), found.guess);
  REQUIRE(slower.existence.truth == Truth::proved);
  REQUIRE(slower.admissible.truth == Truth::refuted);
  CHECK(!slower.stability);
  for (const motion::Condition& condition : slower.conditions) {
    CHECK((condition.verdict.truth == Truth::refuted) == (condition.id == "stick.upper"));
  }
}

TEST_CASE("steady sliding on Stribeck's smooth law is stable from ln(10)/2 on") {
  // c = V's friction slope, exp(-2 V), where 0.1 = exp(-2 V).
  const double lost = std::log(10) / 2;
  const auto at = [](double V) { return steady_sliding(one_mass(Rational("1/10"), Rational(V))); };
  CHECK(at(lost + 1e-12).stability == motion::StabilityKind::stable);
  CHECK(at(lost - 1e-12).stability == motion::StabilityKind::unstable);
  CHECK(holds(at(1.5).friction, 0.5 + 0.5 * std::exp(-3)));
  const SteadyAlong along = steady_sliding_along(
      [](const Rational& V) { return one_mass(Rational("1/10"), V); }, Rational(1), Rational("3/2"));
  REQUIRE(along.changes.size() == 1);
  CHECK(!along.changes[0].is_lost);
  CHECK(!along.changes[0].is_corner);
  CHECK(along.changes[0].first.get_d() < lost);
  CHECK(along.changes[0].last.get_d() > lost);
}

TEST_CASE("what is no smooth law is refused in a sentence") {
  const auto refusal = [](const Rational& first, const Rational& last, const Rational& scale,
                          const Rational& viscous) {
    try {
      Machine machine = one_mass(Rational(0), Rational(1));
      machine.oscillator.forward =
          smooth_law(Rational(1), {model::Fall::exponential, first, last, scale, viscous});
      require_machine(machine);
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal(1, Rational("1/2"), 1, 0).empty());
  CHECK(refusal(-1, 1, 1, 0).find("the sliding friction at 0 = -1") == 0);
  CHECK(refusal(1, -1, 1, 0).find("the sliding friction at high velocities = -1") == 0);
  CHECK(refusal(1, 1, 0, 0).find("the velocity over which sliding friction falls = 0") == 0);
  CHECK(refusal(1, 1, 1, -1).find("the viscous part of sliding friction = -1") == 0);
  CHECK(refusal(2, 1, 1, 0).find("the sliding friction at 0 = 2") == 0);
  // Beside pieces of another law it would be judged by these where it begins.
  Machine machine = one_mass(Rational(0), Rational(1));
  machine.oscillator.forward.smooth->first = 2;
  CHECK_THROWS_WITH_AS(
      require_machine(machine),
      "the sliding friction at 0 = 2 is outside the allowed range: 1, as on the pieces beside it",
      DomainError);
}
