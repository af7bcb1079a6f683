// Appendix 4 in numbers: (54) along P and along the half-period orbits of random data, for all times.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/motion/along.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::examples;

namespace {

// Of the orbits with tau = Theta/2: (54) is no statement about others.
int check_54(const ExactParameters& a) {
  int checked = 0;
  for (const NonstickingOrbit& orbit : list_nonsticking(a, 30).orbits) {
    if (!orbit.tau.overlaps(orbit.tau1)) {
      continue;
    }
    const WorkingPrecision scope(bits_for(30) + 64);
    const SymmetryAlong along = symmetry_54(orbit.motion);
    CAPTURE(along.verdict.reason);
    CHECK(along.verdict.truth == Truth::undecided);
    CHECK((along.bound - Ball(1e-18)).is_negative());
    ++checked;
  }
  return checked;
}

}  // namespace

TEST_CASE("(54) holds along P for all times") {
  CHECK(check_54(P()) == 2);
}

TEST_CASE("(54) holds along the half-period orbits of random data with V = 0") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 6; ++k) {
    ExactParameters a = random.parameters();
    a.V = 0;
    CAPTURE(examples::to_string(a));
    try {
      check_54(a);
    } catch (const DomainError&) {  // a multiple of omega is a natural frequency
    }
  }
}

TEST_CASE("(54) is refuted for an orbit with V not 0, and for a motion that is moved") {
  for (const NonstickingOrbit& orbit : list_nonsticking(P("0.1"), 30).orbits) {
    CHECK(symmetry_54(orbit.motion).verdict.truth == Truth::refuted);
  }
  NonstickingOrbit orbit = list_nonsticking(P(), 30).orbits.at(0);
  orbit.motion.phases[1].Z(0) += Ball(1e-12);
  CHECK(symmetry_54(orbit.motion).verdict.truth == Truth::refuted);
  orbit.motion.phases.pop_back();
  CHECK_THROWS_AS((void)symmetry_54(orbit.motion), InternalError);
}
