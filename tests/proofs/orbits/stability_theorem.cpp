#include <doctest/doctest.h>

#include <algorithm>

#include "proofs/methods/motions.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using numeric::motion::Motion;
using pascal2012::example_named;

namespace {

Theorem stability(const std::string& name, const std::function<void(orbits::Question&)>& change = {}) {
  const Motion& motion = methods::printed_orbit(example_named(name)).motion;
  orbits::Question question = orbits::question_of(methods::question_of(example_named(name)), motion);
  const Theorem orbit = orbits::orbit_theorem(question, motion);
  if (change) {
    change(question);
  }
  return orbits::stability_theorem(orbit, question);
}

// What is said in the end, below all that exists, and how many solutions and matrices exist.
std::pair<Formula, int> verdict(const Theorem& theorem) {
  CHECK(theorem.hypotheses().empty());
  Formula said = theorem.conclusion();
  int bound = 0;
  for (bool inside = true; inside;) {
    inside = said.kind() == Kind::exists || said.kind() == Kind::conjunction;
    if (said.kind() == Kind::exists && said.name() == "mu") {
      break;
    }
    if (said.kind() == Kind::exists) {
      bound += said.binds() == orbits::variation_type || said.binds() == real_matrix(4, 4) ? 1 : 0;
      said = opened(said, Variable{said.name(), said.binds()});
    } else if (inside) {
      said = said.parts().back();
    }
  }
  return {said, bound};
}

}  // namespace

TEST_CASE("the orbits of Figs. 3 and 4 have all multipliers inside the unit circle, that of Fig. 2 has not") {
  const Formula inside = inside_unit_circle(orbits::characteristic()({Variable{"M", real_matrix(4, 4)}}));
  const auto [O, of_O] = verdict(stability("O"));
  CHECK(O == inside);
  CHECK(of_O == 4);
  const auto [P, of_P] = verdict(stability("P"));
  CHECK(P == inside);
  CHECK(of_P == 3);
  const auto [S, of_S] = verdict(stability("S"));
  REQUIRE(S.kind() == Kind::exists);
  CHECK(opened(S, Variable{"mu"}).parts()[0] == less(1, Variable{"mu"}));
  CHECK(of_S == 3);
}

TEST_CASE("of another oscillator or another order of the phases nothing is said") {
  const auto refuses = [](const char * name, const std::function<void(orbits::Question&)>& change) {
    CHECK_THROWS_AS(static_cast<void>(stability(name, change)), KernelError);
  };
  refuses("S", [](orbits::Question& q) { q.durations[0] = "tau2"; });
  refuses("O", [](orbits::Question& q) { std::swap(q.phases[0], q.phases[1]); });
  refuses("P", [](orbits::Question& q) { q.data.V += 1; });
}

TEST_CASE("the characteristic polynomial is the determinant of z I - M, for all M and z") {
  const Variable M{"M", real_matrix(4, 4)}, z{"z"};
  const Term shifted = Term(z) * identity(4) - Term(M);
  CHECK(Theorem::combination(
            equal(determinant(shifted), orbits::polynomial_at()({orbits::characteristic()({M}), z})), {},
            {orbits::characteristic(), orbits::polynomial_at()})
            .hypotheses()
            .empty());
}
