#include "model/appendix3.hpp"

#include <doctest/doctest.h>

using namespace stickslip::model;

namespace {

// Any data; nothing here is periodic.
struct Data {
  double chi = 0.37, omega = 0.83, V = 1.3, phi = 0.45, tau = 1.7, tau1 = 0.9, T = 2.1;
  Modes<double> m = modes<double>(0.37, 2.9);
  Vector2<double> Q{0.7, -0.4}, d0{0.31, 0.23};
  Vector4<double> Z0{0.6, -1.1, 0.8, 1.3};
};

ClosingCoefficients<double> coefficients(const Data& x, Reading reading) {
  return appendix3<double>(
      appendix3_letters<double>(x.chi, x.m, x.Q, x.d0, x.omega, x.V, x.phi, x.tau, x.tau1, x.T), reading);
}

// z1, z2, z1' of Z_C - Gamma(-T) Z0, then z2' - V at tau and at tau + tau1, through the flows.
std::array<double, 5> through_the_flows(const Data& x) {
  const Vector4<double> B = slip_flow<double>(x.m, x.Q, x.omega, x.phi, x.Z0, x.tau);
  const Vector4<double> C =
      overshoot_flow<double>(x.m, x.Q, x.d0, x.omega, x.omega * x.tau + x.phi, B, x.tau1);
  const Vector4<double> gap = C - stick_flow<double>(x.chi, x.Z0, -x.T);
  return {gap(0), gap(1), gap(2), B(3) - x.V, C(3) - x.V};
}

}  // namespace

TEST_CASE("the five equations of Appendix 3 are what the flows leave open, but for the printed c_1") {
  const Data x;
  const std::array<double, 5> expected = through_the_flows(x);
  for (const Reading reading : {Reading::derived, Reading::printed}) {
    const ClosingCoefficients<double> k = coefficients(x, reading);
    for (std::size_t i = 0; i < 5; ++i) {
      CAPTURE(i);
      const double value = k.a[i] * x.Z0(0) + k.b[i] * x.Z0(1) + k.c[i] * x.Z0(2) + k.d[i];
      if (reading == Reading::printed && i == 0) {
        CHECK(value != doctest::Approx(expected[i]));
      } else {
        CHECK(value == doctest::Approx(expected[i]));
      }
    }
  }
}

TEST_CASE("(22) solves the first three equations, and (23) is what is left of the others") {
  const ClosingCoefficients<double> k = coefficients(Data{}, Reading::derived);
  const CramerDeterminants<double> c = cramer<double>(k);
  const double z10 = c.Delta1 / c.Delta, z20 = c.Delta2 / c.Delta, zdot10 = c.Delta3 / c.Delta;
  const auto left = [&](std::size_t i) { return k.a[i] * z10 + k.b[i] * z20 + k.c[i] * zdot10 + k.d[i]; };
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(left(i) == doctest::Approx(0));
  }
  const std::array<double, 2> F = compatibility<double>(k);
  CHECK(F[0] == doctest::Approx(c.Delta * left(3)));
  CHECK(F[1] == doctest::Approx(c.Delta * left(4)));
}
