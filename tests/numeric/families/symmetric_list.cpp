// Complete lists of symmetric orbits: nothing missing, nothing twice, nothing that does not close.
#include "numeric/families/symmetric_list.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::examples;

namespace {

void check_list(const SymmetricList& list) {
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    const SymmetricOrbit& orbit = list.orbits[i];
    CHECK(orbit.tau_unique.contains(orbit.state.tau));
    CHECK(orbit.state.T.is_positive());
    CHECK(orbit.state.tau.is_positive());
    for (int k = 0; k < 4; ++k) {
      CHECK(orbit.residual13(k).contains_zero());
      CHECK(orbit.residual15(k).contains_zero());
      CHECK(orbit.residual16(k).contains_zero());
      CHECK((orbit.residual13(k).radius() - Ball(1e-9)).is_negative());
    }
    for (std::size_t j = 0; j < i; ++j) {
      CHECK((list.orbits[j].phase != orbit.phase || !list.orbits[j].state.tau.overlaps(orbit.state.tau)));
    }
  }
}

SymmetricList complete_list(const ExactParameters& a, std::size_t orbits) {
  const SymmetricList list = list_symmetric(a, 25);
  CHECK(list.complete());
  CHECK(list.orbits.size() == orbits);
  check_list(list);
  return list;
}

}  // namespace

TEST_CASE("example S: two orbits of either load phase, the printed one among them") {
  const SymmetricList list = complete_list(S(), 4);
  CHECK(near(list.orbits[1].state.tau, "7.7467", "0.0001"));
  CHECK(list.orbits[1].phase == LoadPhase::first);
}

TEST_CASE("lists at other data: none, many, without load, near and at special frequencies") {
  complete_list(O(), 2);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "3", "0.05"), 0);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.1", "0.05"), 22);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "5"), 3);
  complete_list(parse_parameters("0.0001", "3.8", "0.02", "1", "0.6", "0.05"), 0);
  complete_list(parse_parameters("0.9999", "3.8", "0.02", "1", "0.6", "0.05"), 4);
  CHECK(complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "0"), 2).load_absent);
}

TEST_CASE("omega = 1/k: the eliminant's zero at tau = 0 is no orbit") {
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "1", "0.05"), 0);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "1/2", "0.05"), 4);
  complete_list(parse_parameters("0.5", "3.8", "0.02", "1", "0.999", "0.05"), 0);
}

TEST_CASE("omega_j = k omega: the closing motion without a stick is told apart") {
  // omega1 = 1/2, omega2 = 2.
  const SymmetricList list = complete_list(parse_parameters("9/13", "169/36", "0.02", "1", "2/3", "0.05"), 2);
  CHECK(list.closes_without_stick);
  CHECK_FALSE(complete_list(S(), 4).closes_without_stick);
  CHECK_THROWS_AS((void)list_symmetric(parse_parameters("9/13", "169/36", "0.02", "1", "1/2", "0.05"), 15),
                  DomainError);
  complete_list(parse_parameters("9/13", "169/36", "0.02", "1", "0.500001", "0.05"), 5);
}

TEST_CASE("what cannot be decided is left open with a reason, and soon") {
  // omega1 = 2 omega, omega2 = 8 omega and omega = 1/4 at once: zeros of high order at the ends and at
  // Theta/2.
  const SymmetricList list =
      list_symmetric(parse_parameters("9/13", "169/36", "0.02", "1", "1/4", "0.05"), 15);
  CHECK_FALSE(list.complete());
  check_list(list);
  for (const UnresolvedTau& open : list.unresolved) {
    CHECK_FALSE(open.reason.empty());
    CHECK((open.tau.radius() - Ball(0.5)).is_negative());
  }
}

TEST_CASE("random data: the list holds every orbit that a scan in floats can find") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 12; ++k) {
    const ExactParameters a = random.parameters();
    CAPTURE(examples::to_string(a));
    const SymmetricList list = list_symmetric(a, 15);
    check_list(list);
    for (const SymmetricProof& proof : solve_symmetric(a, 15)) {
      const bool beyond = proof.orbit.state.T.is_negative() || proof.orbit.state.tau.is_negative();
      if (proof.existence.truth != Truth::proved || beyond ||
          (list.load_absent && proof.orbit.phase == LoadPhase::second)) {
        continue;
      }
      const bool listed = std::any_of(list.orbits.begin(), list.orbits.end(), [&](const SymmetricOrbit& o) {
        return o.phase == proof.orbit.phase && o.state.tau.overlaps(proof.orbit.state.tau);
      });
      CHECK((listed || !list.complete()));
    }
  }
}
