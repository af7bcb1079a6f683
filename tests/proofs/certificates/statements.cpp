// What a certificate states, and what a record of certificates is bound to.
#include "proofs/certificates/statements.hpp"

#include <doctest/doctest.h>

#include "proofs/certificates/script.hpp"

using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::certificates;

namespace {

methods::Record record_of(const Theorem& theorem) {
  methods::Record record;
  record.claim.id = "1.a";
  record.claim.place = "sec3";
  record.claim.words = "what (* it *) says";
  record.outcome.theorems = {theorem};
  record.outcome.verdict.truth = stickslip::Truth::proved;
  return record;
}

}  // namespace

TEST_CASE("a claim's theorems have names, and a comment that is one") {
  const std::vector<NamedTheorem> named = named_theorems(record_of(Theorem::reflexive(Variable{"x"})));
  REQUIRE(named.size() == 1);
  CHECK(named[0].name == "claim_1_a_1");
  CHECK(named[0].about == "1.a, Section 3: what ( * it * ) says");
}

TEST_CASE("the fingerprint is of what is said: another hypothesis, sign or definition is another") {
  const Variable x{"x"}, y{"y"};
  const Definition twice("twice", {x}, Term(x) + x), thrice("twice", {x}, Term(3) * x);
  const std::string one = fingerprint(record_of(Theorem::assume(less(x, y))));
  CHECK(one == fingerprint(record_of(Theorem::assume(less(x, y)))));
  std::set<std::string> all{one};
  for (const Theorem& other : {Theorem::assume(at_most(x, y)), Theorem::assume(less(y, x)),
                               Theorem::discharge(Theorem::assume(less(x, y)), less(0, x)),
                               Theorem::assume(less(twice({x}), y)), Theorem::assume(less(thrice({x}), y))}) {
    CHECK(all.insert(fingerprint(record_of(other))).second);
  }
}

TEST_CASE("a variable cannot hide a definition") {
  const Variable x{"x"};
  const Definition chi("chi", {x}, Term(2) * x), H("H", {x}, Term(2) * x);
  // The paper's chi and eta are both: the variable has another name.
  const Theorem named = Theorem::reflexive(chi({Variable{"chi"}}));
  CHECK(stated(named).text.find("chi chi' = chi chi'") != std::string::npos);
  std::vector<Definition> found;
  CHECK_NOTHROW(collect_definitions(named, found));
  // Any other is refused, free or bound.
  for (const Formula& formula : {equal(H({Variable{"H"}}), 0), for_all({"H"}, equal(H({Variable{"H"}}), 0)),
                                 all({equal(H({x}), 0), exists({"H"}, equal(Variable{"H"}, 0))})}) {
    Library library;
    Script script("file", library);
    CHECK_THROWS_AS(script.add("name", Theorem::assume(formula)), KernelError);
  }
}
