// What a certificate states, and what a record of certificates is bound to.
#include "proofs/certificates/statements.hpp"

#include <doctest/doctest.h>

#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/certificates/statement_files.hpp"

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

TEST_CASE("what a definition or an assumption says alone is counted apart") {
  const Variable x{"x"}, y{"y"};
  const Definition twice("twice", {x}, Term(x) + x);
  CHECK(is_immediate(Theorem::reflexive(x)));
  CHECK(is_immediate(Theorem::assume(less(x, y))));
  CHECK(is_immediate(
      Theorem::convert(Theorem::reflexive(twice({y})), equal(twice({y}), Term(y) + y), {twice})));
  CHECK_FALSE(is_immediate(Theorem::combination(equal(Term(x) + y, Term(y) + x))));
  CHECK_FALSE(is_immediate(Theorem::discharge(Theorem::assume(less(x, y)), less(x, y))));
}

TEST_CASE("an abbreviation stands where its body does, of whatever arguments, and for nothing else") {
  const Variable x{"x"}, y{"y"}, t{"t"};
  const Definition unit("I2", {}, identity(2)), wave("wave", {x, y}, cos(Term(x) * y) + x);
  const auto is = [&](const Term& term, const Term& shorter) {
    const Term result = shortened(term, {unit, wave});
    CHECK(coq(result) == coq(shorter));
    CHECK(unfold(result, {unit, wave}) == term);
  };
  is(identity(2) + zero(real_matrix(2, 2)), unit({}) + zero(real_matrix(2, 2)));
  is(matrix(2, 2, {1, 0, 0, 2}), matrix(2, 2, {1, 0, 0, 2}));
  is(sin(cos(Term(2) * pi()) + 2), sin(wave({Term(2), pi()})));
  is(cos(Term(2) * pi()) + 3, cos(Term(2) * pi()) + 3);
  // Not of what a binder binds.
  is(for_all(t, less(cos(Term(t) * y) + t, 1)), for_all(t, less(cos(Term(t) * y) + t, 1)));
  is(for_all(t, less(cos(Term(x) * y) + x, t)), for_all(t, less(wave({Term(x), Term(y)}), t)));
}

TEST_CASE("the file of statements has each under its theorem's name, and Final.v compares them") {
  const Variable x{"x"};
  const Definition twice("twice", {x}, Term(x) + x);
  const methods::Record record =
      record_of(Theorem::convert(Theorem::reflexive(twice({x})), equal(twice({x}), Term(x) + x), {twice}));
  CHECK(definitions_file({&record}).find("Definition twice (x : R) : R :=\n  x + x.\n") != std::string::npos);
  const std::string text = statements_file({&record}, {});
  CHECK(text.find("Definition twice_is : twice =\n  (fun (x : R) =>\n   x + x) := eq_refl.\n") !=
        std::string::npos);
  CHECK(
      text.find(
          "(* 1.a, Section 3: what ( * it * ) says *)\nDefinition claim_1_a_1 : Prop :=\n  forall (x : R),\n"
          "  twice x = x + x.\n") != std::string::npos);
  const std::string final_text = final_file({{"Claim_1_a", {"claim_1_a_1"}}});
  CHECK(final_text.find("Check (Stickslip.Claim_1_a.claim_1_a_1 : Stickslip.Statements.claim_1_a_1).\n") !=
        std::string::npos);
  CHECK(final_text.ends_with("Print Assumptions every.\n"));
  // Two definitions of one name mean two things.
  const Definition other("twice", {x}, Term(2) * x);
  const methods::Record another = record_of(Theorem::reflexive(other({x})));
  CHECK_THROWS_AS((void)definitions_file({&record, &another}), KernelError);
}
