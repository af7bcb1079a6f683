// The determinant of (16): what it is made of, and that wrong factors do not pass; the frequencies as
// parameters.
#include <doctest/doctest.h>

#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/checks/decided.hpp"
#include "tests/proofs/checks/wrong.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

// The claim's verdict on another statement, or without one of its assumptions.
Truth altered(const std::string& id, const std::function<void(Claim&)>& alter) {
  Claim claim = claim_named(paper().claims, id);
  alter(claim);
  Prover prover(paper().claims);
  return claim.prove(prover, claim).verdict.truth;
}

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("the determinant of (16) has three cosines for factors, and no others") {
  CHECK(record("16.det").outcome.by_kernel);
  CHECK(hypotheses("16.det").empty());
  for (const Term& wrong : {Term(2), Term(-1), cos(omega1 * tau / 2), sin(T / 2), 1 / cos(T / 2), omega1}) {
    CHECK(altered("16.det", [&](Claim& claim) {
            claim.printed.front().right = wrong * claim.printed.front().right;
          }) != Truth::proved);
  }
}

TEST_CASE("an orbit needs a zero of the last factor: by both (13) and (15), with the time lag and V") {
  CHECK(record("16.orbits").outcome.by_kernel);
  for (const char * needed : {"4.lag", "13", "15", "25.V", "2.slip", "6.Z0"}) {
    CAPTURE(needed);
    CHECK(record("16.orbits").outcome.assumed.contains(needed));
    CHECK(altered("16.orbits", [&](Claim& claim) {
            std::erase_if(claim.assumptions, [&](const Assumption& one) { return one.id == needed; });
          }) != Truth::proved);
  }
  CHECK(altered("16.orbits", [](Claim& claim) { claim.printed.front().right = 1; }) != Truth::proved);
}

TEST_CASE("there are frequencies for all chi between 0 and 1 and eta > 0, by a theorem that says so") {
  namespace k = proofs::kernel;
  const Outcome& outcome = record("39.frequencies").outcome;
  REQUIRE(outcome.theorems.size() == 1);
  const k::Variable c{"chi"}, e{"eta"}, first{"omega1"}, second{"omega2"};
  Reader read;
  const k::Formula wanted =
      k::exists(first, k::exists(second, k::all({k::less(0, first), k::less(first, 1), k::less(1, second),
                                                 k::equal(read(chi), c), k::equal(read(eta), e)})));
  CHECK(outcome.theorems.front().conclusion() == wanted);
  CHECK(outcome.theorems.front().hypotheses() == k::Formulas{k::less(0, c), k::less(c, 1), k::less(0, e)});
  CHECK(record("39.range").status == Status::proved);
  CHECK(altered("39.range", [](Claim& claim) { claim.printed[1].relation = Relation::greater; }) !=
        Truth::proved);
}

TEST_CASE(
    "(3) names what exists for all positive masses and stiffnesses, and main theorems hold for all data") {
  namespace k = proofs::kernel;
  k::Formulas positive;
  for (const char * name : {"m1", "m2", "k1", "k2"}) {
    positive.insert(k::less(0, k::Variable{name}));
  }
  CHECK(record("3.exist").outcome.theorems.front().hypotheses() == positive);
  const k::Variable c{"chi"}, e{"eta"};
  const Outcome& all = record("39.data").outcome;
  REQUIRE(all.theorems.size() == 6);
  for (const k::Theorem& theorem : all.theorems) {
    CHECK(theorem.hypotheses() == k::Formulas{k::less(0, c), k::less(c, 1), k::less(0, e)});
    CHECK(theorem.conclusion().variables() == k::Variables{c, e});
  }
}

TEST_CASE("no orbit has the tau or the u_r of Fig. 2, and no solution of (16) that tau, by theorems") {
  for (const char * id : {"S.none.tau", "S.none.ur", "S.16"}) {
    CAPTURE(id);
    CHECK(record(id).outcome.by_kernel);
    CHECK(record(id).outcome.theorems.size() == 1);
    CHECK(record(id).outcome.theorems.front().hypotheses().empty());
  }
  CHECK(record("S.none.tau").status == Status::proved);
  CHECK(record("S.none.ur").status == Status::proved);
  CHECK(record("S.16").status == Status::digits_off);
  CHECK(altered("16.zeros", [](Claim& claim) { claim.assumptions.pop_back(); }) != Truth::proved);
}

TEST_CASE("at the data of Fig. 2 six of the eight zeros are no orbits") {
  CHECK(record("S.det").status == Status::proved);
}

TEST_SUITE_END();
