// Example S (Fig. 2) and the symmetric orbits in general.
#include "numeric/families/symmetric.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

void check_zero_within(const model::Vector4<Ball>& residual, const char * bound) {
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(residual(i).contains_zero());
    CHECK((residual(i).radius() - Ball(parse_rational(bound))).is_negative());
  }
}

// The orbit of Fig. 2: the paper's load phase, tau near the printed one.
SymmetricOrbit orbit_S(int digits) {
  for (const SymmetricProof& proof : solve_symmetric(S(), digits)) {
    if (proof.orbit.phase == LoadPhase::first && near(proof.orbit.state.tau, "7.749", "0.01")) {
      REQUIRE(proof.existence.truth == Truth::proved);
      return proof.orbit;
    }
  }
  FAIL("no orbit near the printed tau");
  return {};
}

}  // namespace

TEST_CASE("example S closes in all components of (13), (15) and (16)") {
  const SymmetricOrbit orbit = orbit_S(30);
  check_zero_within(orbit.residual13, "1e-28");
  check_zero_within(orbit.residual15, "1e-28");
  check_zero_within(orbit.residual16, "1e-28");
  CHECK(orbit.tau_unique.contains(orbit.state.tau));
  CHECK(orbit.C_unique.contains(orbit.state.C));
}

TEST_CASE("a thousand digits, and enclosures at different precisions that overlap") {
  const SymmetricOrbit coarse = orbit_S(20);
  const SymmetricOrbit fine = orbit_S(1000);
  const WorkingPrecision precision(3500);
  CHECK(coarse.state.tau.overlaps(fine.state.tau));
  CHECK(coarse.state.ur.overlaps(fine.state.ur));
  CHECK((fine.state.tau.radius() - Ball(parse_rational("1e-1000"))).is_negative());
  CHECK((fine.state.ur.radius() - Ball(parse_rational("1e-1000"))).is_negative());
  check_zero_within(fine.residual13, "1e-1000");
}

TEST_CASE("the paper's (16) has exactly one zero near the orbit, the same one") {
  const SymmetricState<Ball> s = orbit_S(20).state;
  const Box<4> guess = midpoint<4>(Box<4>(s.tau, s.z10, s.z20, s.zdot10));
  const ZeroProof<4> proof = prove_zero_near<4>(equations_16<Ball>(S(), LoadPhase::first), guess);
  REQUIRE(proof.verdict.truth == Truth::proved);
  CHECK(proof.box(0).overlaps(s.tau));
  CHECK(proof.box(1).overlaps(s.z10));
  CHECK(proof.box(2).overlaps(s.z20));
  CHECK(proof.box(3).overlaps(s.zdot10));
}

TEST_CASE("a guess that is no orbit is not proved") {
  const SymmetricOrbit orbit = orbit_S(20);
  const double tau = orbit.state.tau.approximate();
  const double C = orbit.state.C.approximate();
  for (const double shift : {1e-2, -1e-2, 0.3}) {
    CAPTURE(shift);
    const SymmetricProof proof = prove_symmetric(S(), LoadPhase::first, {tau + shift, C}, 20);
    if (proof.existence.truth == Truth::proved) {  // then of the very same orbit
      CHECK(proof.orbit.state.tau.overlaps(orbit.state.tau));
    }
  }
  CHECK(prove_symmetric(S(), LoadPhase::second, {tau, C}, 20).existence.truth != Truth::proved);
}

TEST_CASE("the printed values of example S, in the paper's own equations") {
  const PrintedZero zero = printed_zero_of_16(
      S(), LoadPhase::first,
      {parse_decimal("7.749"), parse_decimal("1.0609"), parse_decimal("1.3615"), parse_decimal("0.581")});
  for (int i = 0; i < 4; ++i) {
    CHECK(zero.at_intervals(i).contains(zero.at_points(i)));
  }
  CHECK(zero.verdict.truth == Truth::refuted);
  // The same test on intervals around the proved values accepts them.
  const PrintedZero right = printed_zero_of_16(S(), LoadPhase::first,
                                               {parse_decimal("7.746695"), parse_decimal("1.061513"),
                                                parse_decimal("1.362640"), parse_decimal("0.580303")});
  CHECK(right.verdict.truth != Truth::refuted);
}

TEST_CASE("data outside the domain are refused by name") {
  const auto refuse = [](const ExactParameters& a) { (void)solve_symmetric(a, 20); };
  CHECK_THROWS_AS(refuse(parse_parameters("1", "3.8", "0.02", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "0", "0.02", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0", "1", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "0", "0.6", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "1", "0", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "-1")), DomainError);
  // omega1 = 1/2 and omega2 = 2 by (39): chi eta = 13/4, 1 - chi = 4/13.
  CHECK_THROWS_AS(refuse(parse_parameters("9/13", "169/36", "0.02", "1", "0.5", "0.05")), DomainError);
  CHECK_THROWS_AS(refuse(parse_parameters("9/13", "169/36", "0.02", "1", "2", "0.05")), DomainError);
}
