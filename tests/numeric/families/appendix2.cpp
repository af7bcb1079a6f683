// Appendix 2 in numbers: (17) along every symmetric orbit, for all times.
#include <doctest/doctest.h>

#include "numeric/families/symmetric_list.hpp"
#include "numeric/motion/along.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::examples;

namespace {

void check_17(const ExactParameters& a) {
  for (const SymmetricOrbit& orbit : list_symmetric(a, 30).orbits) {
    const WorkingPrecision scope(orbit.bits);
    const SymmetryAlong along = symmetry_17(motion_of(a, orbit));
    CAPTURE(along.verdict.reason);
    CHECK(along.verdict.truth == Truth::undecided);
    CHECK((along.bound - Ball(1e-18)).is_negative());
  }
}

}  // namespace

TEST_CASE("(17) holds along S and along the other orbits at its data") {
  REQUIRE(list_symmetric(S(), 30).orbits.size() == 4);
  check_17(S());
}

TEST_CASE("(17) holds along the symmetric orbits of random data") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 6; ++k) {
    const ExactParameters a = random.parameters();
    CAPTURE(examples::to_string(a));
    check_17(a);
  }
}

TEST_CASE("the bound of (17) holds at sampled times, and a shifted motion refutes it") {
  const SymmetricOrbit orbit = list_symmetric(S(), 30).orbits.at(1);
  Motion motion = motion_of(S(), orbit);
  motion.phases[0].Z(2) += Ball(1e-3);
  const SymmetryAlong off = symmetry_17(motion);
  CHECK(off.verdict.truth == Truth::refuted);
  const Ball& tau = motion.phases[0].duration;
  for (const char * text : {"0", "0.4", "2.5", "7"}) {
    const Ball t(parse_rational(text));
    const model::Vector4<Ball> gap =
        state(motion, 0, t) - model::reversal<Ball>() * state(motion, 0, Ball(tau - t));
    for (int i = 0; i < 4; ++i) {
      CHECK_FALSE((abs(gap(i)) - off.bound).is_positive());
    }
  }
  motion = motion_of(S(), orbit);
  motion.phases[1].Z(1) += Ball(1e-9);  // the stick alone
  CHECK(symmetry_17(motion).verdict.truth == Truth::refuted);
}
