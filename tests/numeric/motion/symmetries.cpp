// Symmetries of the flows, in balls: group law, time reversal, reflection, scaling, time shift, and Newton's
// equations in units of one's own through (3). Data are drawn at random, with a bias to corner cases.
#include <doctest/doctest.h>

#include "model/parameters.hpp"
#include "model/waves.hpp"
#include "numeric/scalars/jet.hpp"
#include "tests/numeric/families/random_data.hpp"

// For jets over jets.
namespace stickslip::numeric::scalars {
inline void add_product(Jet<Ball, 1>& sum, const Jet<Ball, 1>& a, const Jet<Ball, 1>& b) {
  sum += a * b;
}
}  // namespace stickslip::numeric::scalars

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::examples;

namespace {

using State = model::Vector4<Ball>;
using Oscillator = model::Oscillator<Ball>;

// Tiny V, chi near its ends, a load near resonance, or anything.
ExactParameters corner_parameters(RandomData& random) {
  ExactParameters a = random.parameters();
  switch (static_cast<int>(random.between(0, 5).get_d())) {
    case 0:
      a.V = Rational(1, 1000000);
      break;
    case 1:
      a.chi = Rational(1, 100000);
      break;
    case 2:
      a.chi = 1 - Rational(1, 100000);
      break;
    case 3: {  // chi = 1/2, eta = 1: omega_1^2 = (3 - sqrt 5)/4
      a.chi = Rational(1, 2);
      a.eta = 1;
      a.omega = Rational(437016, 1000000);
      break;
    }
    default:
      break;
  }
  return a;
}

struct Draw {
  ExactParameters a;
  Oscillator o;
  State Z;
  Ball psi, t, s;
};

Draw draw(RandomData& random) {
  const ExactParameters a = corner_parameters(random);
  const auto ball = [&](double low, double high) { return Ball(random.between(low, high)); };
  return {a,
          model::oscillator<Ball>(parameters_as<Ball>(a)),
          {ball(-2, 2), ball(-2, 2), ball(-1, 1), ball(-1, 1)},
          ball(-3, 3),
          ball(0, 9),
          ball(0, 9)};
}

State slip(const Draw& d, const State& Z, const Ball& psi, const Ball& t) {
  return model::slip_flow<Ball>(d.o.modes, d.o.Q, d.o.data.omega, psi, Z, t);
}
State overshoot(const Draw& d, const State& Z, const Ball& psi, const Ball& t) {
  return model::overshoot_flow<Ball>(d.o.modes, d.o.Q, d.o.d0, d.o.data.omega, psi, Z, t);
}
State stick(const Draw& d, const State& Z, const Ball& t) {
  return model::stick_flow<Ball>(d.o.data.chi, Z, t);
}
// x = z + d0 and back.
State place(const Draw& d, const State& Z, int sign) {
  State X = Z;
  X(0) += Ball(sign) * d.o.d0(0);
  X(1) += Ball(sign) * d.o.d0(1);
  return X;
}

// Both contain the same vector, and say something.
void check_same(const State& a, const State& b) {
  for (int i = 0; i < 4; ++i) {
    CHECK(a(i).overlaps(b(i)));
    CHECK(((a(i) - b(i)).radius() - Ball(1e-20) * (Ball(1) + abs(a(i)))).is_negative());
  }
}

template <class Check>
void at_random_data(const Check& check) {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  const WorkingPrecision precision(256);
  for (int i = 0; i < 60; ++i) {
    const Draw d = draw(random);
    CAPTURE(to_string(d.a));
    check(d);
  }
}

const State origin(Ball(0), Ball(0), Ball(0), Ball(0));

}  // namespace

TEST_CASE("group law: a flow for t and then for s is the flow for t + s") {
  at_random_data([](const Draw& d) {
    const Ball later = d.psi + d.o.data.omega * d.t;
    check_same(slip(d, slip(d, d.Z, d.psi, d.t), later, d.s), slip(d, d.Z, d.psi, d.t + d.s));
    check_same(overshoot(d, overshoot(d, d.Z, d.psi, d.t), later, d.s), overshoot(d, d.Z, d.psi, d.t + d.s));
    check_same(stick(d, stick(d, d.Z, d.t), d.s), stick(d, d.Z, d.t + d.s));
  });
}

TEST_CASE("time reversal: backwards from the end with the velocity and the load turned round") {
  at_random_data([](const Draw& d) {
    const auto turned = [](State Z) {
      Z(2) = -Z(2);
      Z(3) = -Z(3);
      return Z;
    };
    const Ball end = -(d.psi + d.o.data.omega * d.t);
    check_same(turned(slip(d, turned(slip(d, d.Z, d.psi, d.t)), end, d.t)), d.Z);
    check_same(turned(overshoot(d, turned(overshoot(d, d.Z, d.psi, d.t)), end, d.t)), d.Z);
    check_same(turned(stick(d, turned(stick(d, d.Z, d.t)), d.t)), d.Z);
    check_same(slip(d, slip(d, d.Z, d.psi, d.t), -end, -d.t), d.Z);
  });
}

TEST_CASE("x to -x with phi to phi + pi: the slip becomes the overshoot") {
  at_random_data([](const Draw& d) {
    const State X = place(d, slip(d, d.Z, d.psi, d.t), 1);
    const State mirrored = place(d, -place(d, d.Z, 1), -1);
    check_same(place(d, overshoot(d, mirrored, d.psi + Ball::pi(), d.t), 1), -X);
    check_same(stick(d, -d.Z, d.t), -stick(d, d.Z, d.t));
  });
}

TEST_CASE("(x, u_s, p) to c (x, u_s, p): the flows are linear") {
  at_random_data([](const Draw& d) {
    const Ball c = Ball(Rational(7, 3)) + d.s;
    Draw scaled = d;
    scaled.o.Q = d.o.Q * c;
    scaled.o.d0 = d.o.d0 * c;
    check_same(slip(scaled, d.Z * c, d.psi, d.t), slip(d, d.Z, d.psi, d.t) * c);
    check_same(overshoot(scaled, d.Z * c, d.psi, d.t), overshoot(d, d.Z, d.psi, d.t) * c);
    model::Parameters<Ball> larger = d.o.data;
    larger.us *= c;
    larger.p *= c;
    larger.V *= c;
    const Oscillator o = model::oscillator<Ball>(larger);
    check_same(model::stack<Ball>(o.Q, o.d0), model::stack<Ball>(scaled.o.Q, scaled.o.d0));
  });
}

TEST_CASE("a load that is a turn later is the same load") {
  at_random_data([](const Draw& d) {
    check_same(slip(d, d.Z, d.psi + Ball(2) * Ball::pi(), d.t), slip(d, d.Z, d.psi, d.t));
    const Ball Theta = Ball(2) * Ball::pi() / d.o.data.omega;
    check_same(slip(d, origin, d.psi + d.o.data.omega * Theta, d.t), slip(d, origin, d.psi, d.t));
  });
}

// Masses, springs, friction and load in units of one's own, and (2) in them by Newton.
TEST_CASE("Newton's equations hold in any units, through (3)") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  const WorkingPrecision precision(256);
  using First = Jet<Ball, 1>;
  using Second = Jet<First, 1>;
  for (int i = 0; i < 40; ++i) {
    const auto any = [&] { return Ball(random.between(0.01, 900)); };
    const Ball m1 = any(), m2 = any(), k1 = any(), k2 = any(), force = any(), load = any();
    const Ball frequency = Ball(random.between(0.2, 3)), psi = Ball(random.between(-3, 3));
    const Ball Omega = sqrt((k1 + k2) / m1), eta = m1 / m2,
               omega = frequency;  // frequency of the load: Omega omega
    const model::Parameters<Ball> a{k2 / (k1 + k2), eta,   force / (k1 + k2),
                                    Ball(0),        omega, eta * load / (k1 + k2)};
    const Oscillator o = model::oscillator<Ball>(a);
    const Ball clock = Ball(random.between(0, 5)) / Omega;  // in seconds
    const Second t = Second::variable(First::variable(clock, 0), 0) * Second(First(Omega));
    const auto lifted = [](const Ball& x) { return Second(First(x)); };
    const model::Vector4<Second> Z0(lifted(any()), lifted(any()), lifted(any()), lifted(any()));
    const model::Vector4<Second> Z = model::slip_flow<Second>(
        model::lift<Second>(o.modes), model::lift<Second>(o.Q), lifted(omega), lifted(psi), Z0, t);
    const Ball x1 = Z(0).value.value + o.d0(0), x2 = Z(1).value.value + o.d0(1);
    const Ball acceleration1 = Z(0).partials[0].partials[0], acceleration2 = Z(1).partials[0].partials[0];
    const Ball driving = force + load * cos(Omega * omega * clock + psi);
    const Ball first = m1 * acceleration1 + k1 * x1 - k2 * (x2 - x1);
    const Ball second = m2 * acceleration2 + k2 * (x2 - x1) - driving;
    CHECK(first.contains_zero());
    CHECK(second.contains_zero());
    CHECK((first.radius() - Ball(1e-30) * (Ball(1) + abs(m1 * acceleration1))).is_negative());
    CHECK((second.radius() - Ball(1e-30) * (Ball(1) + abs(driving) + abs(k2 * x2))).is_negative());
    CHECK((Z(2).value.value * Omega - Z(0).partials[0].value).contains_zero());
  }
}
