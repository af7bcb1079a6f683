// Appendix 5 in numbers: xi_i, X_i, Y_i, P_i, rho_i, and det P at and near resonance.
#include <doctest/doctest.h>

#include "model/nonsticking.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::examples;
using model::Matrix2;
using model::Vector2;
using model::Vector4;

namespace {

void check_zero(const Ball& x) {
  CHECK(x.contains_zero());
  CHECK((x.radius() - Ball(1e-20)).is_negative());
}
template <class Matrix>
void check_equal(const Matrix& a, const Matrix& b) {
  for (int i = 0; i < a.size(); ++i) {
    check_zero(a.data()[i] - b.data()[i]);
  }
}

// (57) from its definition for the motion through Z0 that overshoots from Z_B at tau, whether it closes or
// not: xi_2 is that of the overshoot that ends at Z0.
struct Xi {
  Vector4<Ball> first, second;
};
Xi xi_of(const model::Oscillator<Ball>& o, const Ball& phi, const Vector4<Ball>& Z0, const Ball& tau,
         const Ball& tau1) {
  const Ball& omega = o.data.omega;
  const Vector4<Ball> F0 = model::F<Ball>(o.Q, omega, phi);
  const Ball phi_B = omega * tau + phi;
  const Vector4<Ball> FB = model::F<Ball>(o.Q, omega, phi_B);
  Vector4<Ball> twice_d0 = Vector4<Ball>::Constant(Ball(0));
  twice_d0.head<2>() = o.d0 * Ball(2);
  const model::Matrix4<Ball> E = model::reversal<Ball>();
  const Vector4<Ball> slip_end = model::slip_flow<Ball>(o.modes, o.Q, omega, phi, Z0, tau);
  // The load has the period tau + tau1: backwards from (Z0, phi) by tau1 is at the load's phase phi_B.
  const Vector4<Ball> overshoot_start =
      model::overshoot_flow<Ball>(o.modes, o.Q, o.d0, omega, phi, Z0, -tau1);
  return {Vector4<Ball>(slip_end - FB + E * Vector4<Ball>(Z0 - F0)),
          Vector4<Ball>(overshoot_start + twice_d0 - FB + E * Vector4<Ball>(Z0 + twice_d0 - F0))};
}

Matrix2<Ball> P_of(const model::Modes<Ball>& m, const Ball& tau, const Ball& tau1) {
  return model::speed_from_place<Ball>(m, tau) + model::speed_from_place<Ball>(m, tau1);
}
Ball det(const Matrix2<Ball>& m) {
  return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
}

}  // namespace

TEST_CASE("(57), (63), (70) at random data, states and times") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  const WorkingPrecision precision(192);
  for (int k = 0; k < 20; ++k) {
    const ExactParameters a = random.parameters();
    CAPTURE(examples::to_string(a));
    const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
    const model::Modes<Ball>& m = o.modes;
    const Ball Theta = Ball(2) * Ball::pi() / o.data.omega;
    const Ball tau = Theta * Ball(random.between(0.1, 0.9));
    const Ball tau1 = Theta - tau;
    const Ball phi(random.between(-3, 3));
    const Vector4<Ball> Z0(Ball(random.between(-2, 2)), Ball(random.between(-2, 2)),
                           Ball(random.between(-2, 2)), Ball(0));
    const Xi xi = xi_of(o, phi, Z0, tau, tau1);
    check_equal<Vector2<Ball>>(Vector2<Ball>(xi.first.tail<2>()),
                               model::speed_from_place<Ball>(m, tau) * xi.first.head<2>());
    check_equal<Vector2<Ball>>(Vector2<Ball>(xi.second.tail<2>()),
                               -(model::speed_from_place<Ball>(m, tau1) * xi.second.head<2>()));
    const Matrix2<Ball> P = P_of(m, tau, tau1);
    const Ball rho1 = model::rho<Ball>(m.omega1, tau, tau1);
    const Ball rho2 = model::rho<Ball>(m.omega2, tau, tau1);
    const Matrix2<Ball> L = model::Lambda(m);
    check_equal<Matrix2<Ball>>(P, L * model::diagonal<Ball>(rho1, rho2) * model::inverse<Ball>(L));
    check_zero((det(P) - rho1 * rho2) / (Ball(1) + abs(rho1 * rho2)));
  }
}

TEST_CASE("det P vanishes at resonance, whatever tau, and not beside it") {
  // omega1 = 1/2, omega2 = 2.
  const model::Modes<Ball> m = model::modes<Ball>(Ball(Rational(9, 13)), Ball(Rational(169, 36)));
  for (const Rational& omega : {Rational(1, 2), Rational(2, 3), Rational(1, 4), Rational(2)}) {
    CAPTURE(to_string(omega));
    for (const Rational& share : {Rational(3, 10), Rational(13, 20), Rational(9, 11)}) {
      const auto det_P = [&](const Rational& w) {
        const Ball Theta = Ball(2) * Ball::pi() / Ball(w);
        const Ball tau = Theta * Ball(share);
        return det(P_of(m, tau, Theta - tau));
      };
      check_zero(det_P(omega));
      CHECK(det_P(omega + Rational(1, 1000000)).is_nonzero());
      CHECK(det_P(omega - Rational(1, 1000000)).is_nonzero());
    }
  }
}

TEST_CASE("(65), (66), (69) on both half-period orbits at the data of P") {
  const OrbitList list = listed(nonsticking(), P(), 30);
  REQUIRE(list.orbits.size() == 2);
  for (const Orbit& orbit : list.orbits) {
    const WorkingPrecision scope(bits_for(30) + 64);
    const model::Oscillator<Ball>& o = orbit.motion.oscillator;
    const Vector4<Ball>& Z0 = orbit.motion.phases[0].Z;
    const Xi xi = xi_of(o, orbit.value("phi"), Z0, orbit.value("tau"), orbit.value("tau1"));
    CHECK(det(P_of(o.modes, orbit.value("tau"), orbit.value("tau1"))).is_nonzero());
    check_equal<Vector4<Ball>>(xi.first, Vector4<Ball>::Constant(Ball(0)));
    check_equal<Vector4<Ball>>(xi.second, Vector4<Ball>::Constant(Ball(0)));
    const Vector2<Ball> forced = o.Q * cos(orbit.value("phi"));
    check_equal<Vector2<Ball>>(Vector2<Ball>(orbit.value("x10"), orbit.value("x20")), forced);
    const Vector2<Ball> xB = orbit.motion.phases[1].Z.head<2>() + o.d0;
    check_equal<Vector2<Ball>>(xB, -forced);
  }
}
