// The same orbits enclosed at different precisions: the enclosures overlap, and the finer lie in the coarser.
#include <doctest/doctest.h>

#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric_list.hpp"
#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

using Values = std::vector<Ball>;

Values values(const SymmetricProof& proof) {
  REQUIRE(proof.existence.truth == Truth::proved);
  const SymmetricState<Ball>& s = proof.orbit.state;
  return {s.tau, s.T, s.Theta, s.phi, s.z10, s.z20, s.zdot10, s.x10, s.x20, s.ur, s.C};
}
Values values(const OvershootingProof& proof) {
  REQUIRE(proof.existence.truth == Truth::proved);
  const OvershootingState<Ball>& s = proof.orbit.state;
  return {s.tau, s.tau1, s.T, s.Theta, s.z10, s.z20, s.zdot10, s.x10, s.x20, s.ur};
}
Values values(const NonstickingProof& proof) {
  REQUIRE(proof.existence.truth == Truth::proved);
  const NonstickingOrbit& o = proof.orbit;
  return {o.tau, o.tau1, o.Theta, o.phi, o.x10, o.x20, o.xdot10, o.ur_max};
}

// prove: digits -> Values.
template <class Prove>
void check_precisions(const Prove& prove) {
  std::vector<Values> all;
  for (const long bits : {64L, 128L, 256L, 1024L}) {
    CAPTURE(bits);
    all.push_back(prove(static_cast<int>(static_cast<double>(bits) * 0.30103)));
    const WorkingPrecision precision(1200);
    Ball ulps(1);
    arb_mul_2exp_si(ulps.raw(), ulps.raw(), 8 - bits);
    for (const Ball& value : all.back()) {
      CHECK((value.radius() - ulps * (Ball(1) + abs(value))).is_negative());
      for (const Values& other : all) {
        CHECK(value.overlaps(other[static_cast<std::size_t>(&value - all.back().data())]));
      }
    }
  }
}

}  // namespace

TEST_CASE("example S at 64, 128, 256 and 1024 bits") {
  const SymmetricState<Ball> s = list_symmetric(S(), 20).orbits.at(1).state;
  const model::Vector2<double> guess(s.tau.approximate(), s.C.approximate());
  check_precisions([&](int digits) { return values(prove_symmetric(S(), LoadPhase::first, guess, digits)); });
}

TEST_CASE("example O at 64, 128, 256 and 1024 bits") {
  for (const OvershootingOrbit& orbit : list_overshooting_at_phase(O(), 0, 20).orbits) {
    const model::Vector2<double> guess(orbit.state.tau.approximate(), orbit.state.tau1.approximate());
    check_precisions([&](int digits) { return values(prove_overshooting_at_phase(O(), 0, guess, digits)); });
  }
}

TEST_CASE("example P at 64, 128, 256 and 1024 bits") {
  const Box<2> box = list_nonsticking(P(), 20).orbits.at(0).box;
  const model::Vector2<double> guess(box(0).approximate(), box(1).approximate());
  check_precisions([&](int digits) { return values(prove_nonsticking(P(), guess, digits)); });
}

TEST_CASE("a guess beside the orbit is not proved to be one") {
  const model::Vector2<double> nowhere(4.5, 2.5);
  CHECK(prove_overshooting_at_phase(O(), 0, nowhere, 20).existence.truth != Truth::proved);
  CHECK(prove_nonsticking(P(), {1.0, 1.0}, 20).existence.truth != Truth::proved);
}
