// The proved orbits under the friction law: closure, event times, multipliers.
#include <doctest/doctest.h>

#include "model/flows.hpp"
#include "numeric/simulation/agreement.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "tests/numeric/simulation/response.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::simulation;
using namespace stickslip::proofs::pascal2012;
using model::Vector4;

namespace {

// The derivative of the map over one period, by central differences of the simulation.
Eigen::Matrix4d differences(const Start& start, double period) {
  constexpr double h = 1e-5;
  Eigen::Matrix4d M;
  for (int i = 0; i < 4; ++i) {
    Start ahead = start;
    Start behind = start;
    ahead.X(i) += h;
    behind.X(i) -= h;
    M.col(i) = (follow(ahead, period).end - follow(behind, period).end) / (2 * h);
  }
  return M;
}

double distance_to(const Eigen::Vector4cd& values, const ComplexBall& mu) {
  const std::complex<double> middle(mu.re.approximate(), mu.im.approximate());
  return (values.array() - middle).abs().minCoeff();
}

}  // namespace

TEST_CASE("the closed-form simulation reproduces the proved orbits") {
  for (const auto& example : printed_examples()) {
    CAPTURE(example.name);
    const Agreement a = agreement(printed_orbit(example), follow);
    CHECK(a.difference.empty());
    CHECK(a.closure < 1e-13);
    CHECK(a.time_error < 1e-13);
  }
}

TEST_CASE("the raw friction law reproduces the proved orbits") {
  for (const auto& example : printed_examples()) {
    CAPTURE(example.name);
    const Agreement a = agreement(printed_orbit(example), [](const Start& start, double duration) {
      return follow_raw_law(start, duration);
    });
    CHECK(a.difference.empty());
    CHECK(a.closure < 1e-9);
    CHECK(a.time_error < 1e-9);
    MESSAGE(example.name << ": closure " << a.closure << ", event times " << a.time_error);
  }
}

TEST_CASE("what is no orbit is not reproduced") {
  Orbit orbit = printed_orbit(example_named("O"));
  orbit.motion.phases.front().Z(0) += Ball(1e-3);
  CHECK(agreement(orbit, follow).closure > 1e-6);
  orbit.motion.phases.pop_back();
  CHECK_FALSE(agreement(orbit, follow).difference.empty());
}

TEST_CASE("multipliers are the eigenvalues of differences of the simulated return map to 8 digits") {
  for (const auto& example : printed_examples()) {
    for (const Orbit& orbit : list_orbits(question_of(example)).orbits) {
      if (!orbit.stability) {
        continue;
      }
      CAPTURE(example.name);
      const Start start = start_of(orbit);
      const Eigen::Vector4cd values =
          zeros::eigenvalues(differences(start, period(orbit.motion).approximate()));
      REQUIRE(orbit.stability->multipliers.size() == 4);
      for (const ComplexBall& mu : orbit.stability->multipliers) {
        CHECK(distance_to(values, mu) < 1e-8);
      }
    }
  }
}

TEST_CASE("multipliers on a moving belt, without sticking") {
  OrbitQuestion q = question_of(example_named("P"));
  q.ur.reset();
  q.parameters.V.middle = parse_rational("0.1");
  int checked = 0;
  for (const Orbit& orbit : list_orbits(q).orbits) {
    if (orbit.stability) {
      const Eigen::Vector4cd values =
          zeros::eigenvalues(differences(start_of(orbit), period(orbit.motion).approximate()));
      for (const ComplexBall& mu : orbit.stability->multipliers) {
        CHECK(distance_to(values, mu) < 1e-8);
        ++checked;
      }
    }
  }
  CHECK(checked == 4);
}

TEST_CASE("the modal response is the slip (5), off resonance") {
  const Motion motion = printed_orbit(example_named("O")).motion;
  const model::Oscillator<Ball>& o = motion.oscillator;
  const Phase& slip = motion.phases.front();
  const Ball h(parse_rational("0.7"));
  const Vector4<Ball> expected = model::slip_flow<Ball>(o.modes, o.Q, o.data.omega, slip.load, slip.Z, h);
  const model::Modes<Ball>& m = o.modes;
  const Ball det = m.lambda2 - m.lambda1;
  Vector4<Ball> Z = Vector4<Ball>::Constant(Ball(0));
  for (int j = 0; j < 2; ++j) {
    const Ball omega_j = j == 0 ? m.omega1 : m.omega2;
    const Ball lambda = j == 0 ? m.lambda1 : m.lambda2;
    const auto mode = [&](const Ball& a, const Ball& b) {
      return j == 0 ? Ball((m.lambda2 * a - b) / det) : Ball((b - m.lambda1 * a) / det);
    };
    const Ball P = j == 0 ? Ball(-o.data.p / det) : Ball(o.data.p / det);
    const Ball y = mode(slip.Z(0), slip.Z(1));
    const Ball v = mode(slip.Z(2), slip.Z(3));
    const auto g = model::modal_response<Ball>(omega_j, o.data.omega, h);
    const Ball yh = g.c * y + g.s * v + P * (g.from_cos * cos(slip.load) - g.from_sin * sin(slip.load));
    const Ball vh = g.c * v - g.stiff * y + P * (g.cos_rate * cos(slip.load) - g.sin_rate * sin(slip.load));
    Z += Vector4<Ball>(yh, lambda * yh, vh, lambda * vh);
    // Constant force: y'' + omega_j² y = 1 from rest.
    CHECK((abs(g.e - (Ball(1) - cos(omega_j * h)) / (omega_j * omega_j)) - Ball(1e-30)).is_negative());
  }
  for (int i = 0; i < 4; ++i) {
    CHECK((abs(Z(i) - expected(i)) - Ball(1e-18)).is_negative());
    CHECK(Z(i).overlaps(expected(i)));
  }
}

TEST_CASE("the modal response at resonance is the secular one") {
  const Ball w(parse_rational("0.8"));
  const Ball h(parse_rational("0.9"));
  const auto g = model::modal_response<Ball>(w, w, h);
  CHECK((abs(g.from_cos - h * sin(w * h) / (Ball(2) * w)) - Ball(1e-30)).is_negative());
  const Ball from_sin = (sin(w * h) - w * h * cos(w * h)) / (Ball(2) * w * w);
  CHECK((abs(g.from_sin - from_sin) - Ball(1e-30)).is_negative());
}
