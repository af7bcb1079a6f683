// Appendix 3 in numbers: the coefficients (47)-(51) against the composed flows (5), (8), (10), and (21)-(23)
// on O.
#include "model/appendix3.hpp"

#include <doctest/doctest.h>

#include "numeric/motion/motion.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

struct Point {
  model::Oscillator<Ball> o;
  Ball phi, tau, tau1, T;
};

// z1, z2, z1' of Z_C - Gamma(-T) Z0, z2'(tau) - V and z2'(tau + tau1) - V, by the flows: the left sides of
// (21).
Box<5> composed(const Point& x, const Ball& z10, const Ball& z20, const Ball& zdot10) {
  const model::Vector4<Ball> Z0(z10, z20, zdot10, x.o.data.V);
  const Motion motion = compose(
      x.o, x.phi, Z0, {{PhaseKind::slip, x.tau}, {PhaseKind::overshoot, x.tau1}, {PhaseKind::stick, x.T}});
  const model::Vector4<Ball>& ZC = motion.phases[2].Z;
  const model::Vector4<Ball> back = model::stick_flow<Ball>(x.o.data.chi, Z0, -x.T);
  Box<5> left;
  left << ZC(0) - back(0), ZC(1) - back(1), ZC(2) - back(2), motion.phases[1].Z(3) - x.o.data.V,
      ZC(3) - x.o.data.V;
  return left;
}

model::ClosingCoefficients<Ball> coefficients(const Point& x,
                                              model::Reading reading = model::Reading::derived) {
  const auto& [data, modes, Q, d0] = x.o;
  return model::appendix3<Ball>(
      model::appendix3_letters<Ball>(data.chi, modes, Q, d0, data.omega, data.V, x.phi, x.tau, x.tau1, x.T),
      reading);
}

void check_equal(const Ball& a, const Ball& b) {
  CHECK((a - b).contains_zero());
  CHECK(((a - b).radius() - Ball(1e-25)).is_negative());
}

}  // namespace

TEST_CASE("all twenty coefficients are those of the composed flows, at random data") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 20; ++k) {
    const ExactParameters a = random.parameters();
    CAPTURE(examples::to_string(a));
    const Point x{model::oscillator<Ball>(parameters_as<Ball>(a)), Ball(random.between(-3, 3)),
                  Ball(random.between(0, 9)), Ball(random.between(0, 9)), Ball(random.between(0, 9))};
    const WorkingPrecision precision(192);
    const model::ClosingCoefficients<Ball> c = coefficients(x);
    const Box<5> at_zero = composed(x, 0, 0, 0);
    const Box<5> by_z10 = composed(x, 1, 0, 0) - at_zero;
    const Box<5> by_z20 = composed(x, 0, 1, 0) - at_zero;
    const Box<5> by_zdot10 = composed(x, 0, 0, 1) - at_zero;
    for (std::size_t i = 0; i < 5; ++i) {
      CAPTURE(i + 1);
      const int row = static_cast<int>(i);
      check_equal(c.a[i], by_z10(row));
      check_equal(c.b[i], by_z20(row));
      check_equal(c.c[i], by_zdot10(row));
      check_equal(c.d[i], at_zero(row));
    }
  }
}

TEST_CASE("the printed sign of Gamma_13 in c_1 contradicts the flows") {
  const Point x{model::oscillator<Ball>(parameters_as<Ball>(O())), Ball(0), Ball(5), Ball(3), Ball(2)};
  const Ball flown = composed(x, 0, 0, 1)(0) - composed(x, 0, 0, 0)(0);
  CHECK((coefficients(x, model::Reading::printed).c[0] - flown).is_nonzero());
}

TEST_CASE("(21), (22) and (23) on every orbit at the data of O") {
  const OrbitList list = listed(overshooting(), O(), 30, Rational(0));
  REQUIRE(list.orbits.size() == 2);
  for (const Orbit& orbit : list.orbits) {
    const WorkingPrecision scope(192);
    const Ball &z10 = orbit.value("z10"), &z20 = orbit.value("z20"), &zdot10 = orbit.value("zdot10");
    const Point x{model::oscillator<Ball>(parameters_as<Ball>(O())), orbit.value("phi"), orbit.value("tau"),
                  orbit.value("tau1"), orbit.value("T")};
    const model::ClosingCoefficients<Ball> k = coefficients(x);
    for (std::size_t i = 0; i < 5; ++i) {
      check_equal(k.a[i] * z10 + k.b[i] * z20 + k.c[i] * zdot10 + k.d[i], Ball(0));
    }
    const model::CramerDeterminants<Ball> c = model::cramer<Ball>(k);
    REQUIRE(c.Delta.is_nonzero());
    check_equal(c.Delta1 / c.Delta, z10);
    check_equal(c.Delta2 / c.Delta, z20);
    check_equal(c.Delta3 / c.Delta, zdot10);
    for (const Ball& F : model::compatibility<Ball>(k)) {
      check_equal(F, Ball(0));
    }
    Point off = x;
    off.tau += Ball(1e-6);
    CHECK(model::compatibility<Ball>(coefficients(off))[0].is_nonzero());
  }
}
