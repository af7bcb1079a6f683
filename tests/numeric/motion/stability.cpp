// Floquet multipliers: two routes, and what must hold of them.
#include "numeric/motion/stability.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "core/error.hpp"
#include "numeric/families/family.hpp"
#include "numeric/motion/multipliers.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::motion;
using namespace stickslip::proofs::pascal2012;

namespace {

StabilityKind stability_of(const OrbitQuestion& q, std::size_t orbit) {
  const OrbitList list = list_orbits(q);
  REQUIRE(orbit < list.orbits.size());
  REQUIRE(list.orbits[orbit].stability);
  return list.orbits[orbit].stability->kind;
}

// Some eigenvalue of the double matrix is nearer to the enclosure than the distance.
bool met(const Eigen::Vector4cd& values, const ComplexBall& mu, double distance) {
  const std::complex<double> middle(mu.re.approximate(), mu.im.approximate());
  return (values.array() - middle).abs().minCoeff() < distance;
}

SquareMatrix real_matrix(long n, const std::vector<double>& entries) {
  SquareMatrix m(n, n);
  for (long i = 0; i < n * n; ++i) {
    m(i / n, i % n) = Ball(entries[static_cast<std::size_t>(i)]);
  }
  return m;
}

}  // namespace

TEST_CASE("eigenvalues are enclosed, real ones as real, pairs as pairs") {
  const auto found = eigenvalues(real_matrix(3, {0, -2, 0, 2, 0, 0, 0, 0, 3}));
  REQUIRE(found);
  CHECK((*found)[0].re.overlaps(Ball(3)));
  CHECK((*found)[0].im.is_exact());
  CHECK((*found)[1].im.overlaps(Ball(2)));
  CHECK((*found)[2].im.overlaps(Ball(-2)));
  CHECK((abs((*found)[1].im - Ball(2)) - Ball(1e-30)).is_negative());
  SquareMatrix unbounded = real_matrix(1, {0});
  unbounded(0, 0) = Ball(1) / Ball(0);
  CHECK_FALSE(eigenvalues(unbounded));
  const auto equal = eigenvalues(real_matrix(2, {1, 0, 0, 1}));
  REQUIRE(equal);
  CHECK((*equal)[0].re.overlaps(Ball(1)));
}

TEST_CASE("the paper's orbits: S is unstable, O and P are stable") {
  CHECK(printed_orbit(example_named("S")).stability->kind == StabilityKind::unstable);
  CHECK(printed_orbit(example_named("O")).stability->kind == StabilityKind::stable);
  CHECK(printed_orbit(example_named("P")).stability->kind == StabilityKind::stable);
}

TEST_CASE("double and balls agree, wherever the period is cut") {
  for (const auto& example : printed_examples()) {
    CAPTURE(example.name);
    const Orbit orbit = printed_orbit(example);
    const MotionOf<double> motion = in_double(orbit.motion);
    REQUIRE(orbit.stability->multipliers.size() == 4);
    for (std::size_t first = 0; first < motion.phases.size(); ++first) {
      const Eigen::Vector4cd values = zeros::eigenvalues(monodromy<double>(motion, first));
      for (const ComplexBall& mu : orbit.stability->multipliers) {
        CHECK(met(values, mu, 1e-11));
      }
    }
  }
}

TEST_CASE("a motion that sticks has the multiplier 0 exactly, others have none") {
  for (const auto& example : printed_examples()) {
    const ComplexBall last = printed_orbit(example).stability->multipliers.back();
    const bool zero = last.re.is_exact() && last.re.contains_zero() && last.im.contains_zero();
    CHECK(zero == families::has_stick(*example.family));
  }
}

TEST_CASE("the determinant of the map of a non-sticking orbit is that of its two crossings") {
  const Orbit orbit = printed_orbit(example_named("P"));
  const MotionOf<double> motion = in_double(orbit.motion);
  double product = 1;
  for (const PhaseOf<double>& phase : motion.phases) {
    const double r = model::friction_at<double>(motion.oscillator.data, phase.Z, phase.load);
    const double us = motion.oscillator.data.us;
    product *= (std::abs(r) - us) / (std::abs(r) + us);
  }
  CHECK(product < 1);
  CHECK(monodromy<double>(motion).determinant() == doctest::Approx(product).epsilon(1e-12));
}

TEST_CASE("without load 1 is a multiplier, so nothing is called stable") {
  for (const char * name : {"S", "O"}) {
    OrbitQuestion q = question_of(example_named(name));
    q.parameters.p.middle = 0;
    for (const Orbit& orbit : list_orbits(q).orbits) {
      if (!orbit.stability) {
        continue;
      }
      CHECK(orbit.stability->kind != StabilityKind::stable);
      bool neutral = false;
      for (const ComplexBall& mu : orbit.stability->multipliers) {
        neutral = neutral || ((mu.re - Ball(1)).is_exact() && (mu.re - Ball(1)).contains_zero());
      }
      CHECK(neutral);
    }
  }
  OrbitQuestion q = question_of(example_named("O"));
  q.parameters.p.middle = 0;
  CHECK(stability_of(q, 1) == StabilityKind::marginal);
}

TEST_CASE("a box of parameters has one stability, or is undecided") {
  OrbitQuestion q = question_of(example_named("P"));
  q.parameters.p.radius = parse_rational("1e-6");
  CHECK(stability_of(q, 0) == StabilityKind::stable);
  const Orbit orbit = printed_orbit(example_named("S"));
  Motion wide = orbit.motion;
  wide.phases.front().Z(0) += Ball::from_interval(-1, 1);
  CHECK(decide_stability(wide).kind == StabilityKind::undecided);
  CHECK_FALSE(decide_stability(wide).reason.empty());
}

TEST_CASE("a moving belt does not destabilise orbits that never stick") {
  OrbitQuestion q = question_of(example_named("P"));
  q.ur.reset();
  q.parameters.V.middle = parse_rational("0.1");
  for (const Orbit& orbit : list_orbits(q).orbits) {
    if (orbit.stability) {
      CHECK(orbit.stability->kind == StabilityKind::stable);
    }
  }
}

TEST_CASE(
    "multipliers that cannot be told apart are inside the unit circle where a form falls along the map") {
  const auto of_block = [](double mu, double coupling) {
    SquareMatrix J(3, 3);
    J << Ball(mu), Ball(coupling), Ball(0), Ball(0), Ball(mu), Ball(coupling), Ball(0), Ball(0), Ball(mu);
    return motion::stability_of(J, false);
  };
  // The norm is above 1.
  const Stability inside = of_block(0.9, 5);
  CHECK(inside.kind == StabilityKind::stable);
  CHECK(inside.multipliers.empty());
  CHECK(inside.reason.empty());
  for (const double mu : {1.0, -1.0, 1.0 + 0x1p-40, 1.5}) {
    CAPTURE(mu);
    CHECK(of_block(mu, 1).kind != StabilityKind::stable);
    CHECK_FALSE((of_block(mu, 1).kind == StabilityKind::undecided && of_block(mu, 1).reason.empty()));
  }
  // Two turns of one angle, so that none can be told from the other, and balls: of all members, or not.
  const auto of_turns = [](double size, double radius) {
    SquareMatrix J = SquareMatrix::Constant(4, 4, Ball(0));
    for (const Eigen::Index k : {0, 2}) {
      J(k, k) = J(k + 1, k + 1) = Ball(0.6 * size);
      J(k, k + 1) = Ball(0.8 * size);
      J(k + 1, k) = Ball(-0.8 * size);
    }
    J(0, 3) = Ball(1);
    for (Eigen::Index i = 0; i < 16; ++i) {
      J.data()[i] += Ball::hull(Ball(-radius), Ball(radius));
    }
    return motion::stability_of(J, false);
  };
  for (const double radius : {0.0, 1e-6, 1e-5}) {
    CHECK(of_turns(0.95, radius).kind == StabilityKind::stable);
  }
  CHECK(of_turns(0.95, 0.1).kind == StabilityKind::undecided);
  CHECK(of_turns(0.9999, 1e-3).kind == StabilityKind::undecided);
  CHECK(of_turns(1, 0).kind != StabilityKind::stable);
  CHECK(of_turns(1.01, 0).kind != StabilityKind::stable);
  SquareMatrix unknown = SquareMatrix::Constant(2, 2, Ball(0));
  arb_indeterminate(unknown(0, 1).raw());
  CHECK(motion::stability_of(unknown, false).kind == StabilityKind::undecided);
}
