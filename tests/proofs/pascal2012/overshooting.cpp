// Section 5 and Appendix 3: what is decided, on what it rests, and that wrong coefficients do not pass.
#include <doctest/doctest.h>

#include "proofs/checks/edits.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/checks/decided.hpp"
#include "tests/proofs/checks/wrong.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::checks;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

std::vector<std::string> coefficient_ids() {
  std::vector<std::string> ids;
  for (int i = 47; i <= 51; ++i) {
    for (const char letter : {'a', 'b', 'c', 'd'}) {
      ids.push_back(std::to_string(i) + "." + letter);
    }
  }
  return ids;
}

// The coefficient claim with another value.
Verdict verdict_on(const std::string& id, const Term& value) {
  static const std::vector<Claim> claims = paper().claims;
  Claim claim = claim_named(claims, id);
  claim.printed = {equation(claim.printed.front().left, value)};
  Prover nothing_else({});
  return claim.prove(nothing_else, claim).verdict;
}

const Entries Ht{"Htilde"}, h_{"h"}, H_{"H"}, G{"Gamma"};

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("nineteen of the twenty coefficients are as printed, c_1 has a wrong sign, and only that") {
  for (const std::string& id : coefficient_ids()) {
    CAPTURE(id);
    CHECK(record(id).status == (id == "47.c" ? Status::misprint_corrected : Status::as_printed));
    CHECK(hypotheses(id).empty());
  }
  const Record& c_1 = record("47.c");
  REQUIRE(c_1.outcome.verdict.witness);
  CHECK_FALSE(c_1.outcome.verdict.witness->left.overlaps(c_1.outcome.verdict.witness->right));
  REQUIRE(c_1.repairs.size() == 1);
  CHECK(text(c_1.repairs.front().statement) == "c_1 = Htilde13 + Gamma13");
  CHECK(latex(c_1.repairs.front().statement) == "c_1 = \\tilde H_{13} + \\Gamma_{13}");
}

TEST_CASE("(19) as printed is refuted, with eta and tau_1 it is the condition of (4)") {
  CHECK(record("19").status == Status::misprint_corrected);
  CHECK(record("19.back").status == Status::as_printed);
  CHECK(record("19.implied").status == Status::proved);
}

TEST_CASE("(21) and the conditions (18)-(20) say the same, where the load is off resonance") {
  const std::set<std::string> off_load_resonance{"omega - omega1 != 0", "omega - omega2 != 0"};
  CHECK(hypotheses("21") == off_load_resonance);
  CHECK(hypotheses("21.back") == off_load_resonance);
  CHECK(record("21").outcome.uses.contains("47.c"));
  CHECK(record("20.back").status == Status::proved);
}

TEST_CASE("(23) is necessary without, sufficient with Delta != 0, and Delta is a negative square") {
  CHECK(record("23").status == Status::as_printed);
  CHECK_FALSE(record("23").outcome.assumed.contains("22.regular"));
  CHECK(record("23.back").outcome.assumed.contains("22.regular"));
  CHECK(record("22.square").status == Status::proved);
  CHECK(record("23.spurious").status == Status::proved);
  CHECK(record("23.spurious").outcome.by_kernel);
  CHECK(record("O.23").outcome.by_kernel);
}

TEST_CASE("example O: the orbit is proved and obeys every condition, which printed numbers are right") {
  for (const char * id : {"O.orbit", "O.tau", "O.Theta", "O.if.slip", "O.if.11.lower", "O.from.z10",
                          "O.from.z20", "O.from.zdot10", "O.from.ur", "O.from.T", "O.c1"}) {
    CAPTURE(id);
    CHECK(record(id).status ==
          (proofs::methods::is_stated(pascal2012::paper(), id) ? Status::as_printed : Status::proved));
  }
  CHECK(record("O.list").status == Status::decided_in_balls);
  for (const char * id : {"O.tau1", "O.T", "O.z10", "O.z20", "O.zdot10", "O.ur", "O.21", "O.23"}) {
    CAPTURE(id);
    CHECK(record(id).status == Status::digits_off);
  }
}

TEST_CASE("every single edit of Appendix 3 is refuted, or is no change at all") {
  int refuted = 0;
  std::vector<std::string> survivors, open;
  for (const std::string& id : coefficient_ids()) {
    const Claim& claim = record(id).claim;
    Prover nothing_else({});
    for (const Edit& edit : edits(proved_form(record(id)).front())) {
      Claim mutant = claim;
      mutant.printed = {edit.statement};
      Outcome outcome = claim.prove(nothing_else, mutant);
      look_for_witness(outcome, nothing_else, mutant);
      const Verdict& verdict = outcome.verdict;
      const bool other_name = !equal(edit.statement.left, claim.printed.front().left);
      if (verdict.truth == Truth::proved) {
        survivors.push_back(id + ": " + text(edit.statement));
      } else if (verdict.truth == Truth::refuted && verdict.witness) {
        ++refuted;
      } else if (!other_name) {
        open.push_back(id + ": " + text(edit.statement));
      }
    }
  }
  CHECK(open == std::vector<std::string>{});
  CHECK(survivors == std::vector<std::string>{});
  CHECK(refuted > 600);
}

TEST_CASE("beside each kind of mutant a rewriting that stays proved") {
  // By the block structure of H and Gamma, and by addition theorems.
  CHECK(verdict_on("49.c", Ht(3, 3) - G(3, 3)).truth == Truth::proved);
  CHECK(verdict_on("50.c", H_(4, 3)).truth == Truth::proved);
  CHECK(verdict_on("47.a", -(G(1, 1) - Ht(1, 1))).truth == Truth::proved);
  CHECK(verdict_on("47.a", H_(1, 1) * h_(1, 1) + H_(1, 2) * h_(2, 1) + H_(1, 3) * h_(3, 1) +
                               H_(1, 4) * h_(4, 1) - cos(T))
            .truth == Truth::proved);
  CHECK(verdict_on("48.b", Ht(4, 4) - 1).truth == Truth::proved);
}

TEST_CASE("every single edit of the determinants (22) is wrong, but that a_1 and c_3 are equal") {
  int tried = 0;
  CHECK(proved_mutants(paper().claims, {"22.Delta"}, tried) ==
        std::vector<std::string>{"22.Delta: Delta = det([c_3, b_1, c_1; a_2, b_2, c_2; a_3, b_3, a_1])",
                                 "22.Delta: Delta2 = det([d_1, c_3, c_1; d_2, a_2, c_2; d_3, a_3, a_1])"});
  CHECK(tried > 100);
}

TEST_SUITE_END();
