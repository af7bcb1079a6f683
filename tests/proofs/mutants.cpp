// A wrong statement must be refuted, and its witness must hold up in an evaluation that does not pass through
// GiNaC.
#include <doctest/doctest.h>

#include <algorithm>

#include "proofs/cross_check.hpp"
#include "proofs/edits.hpp"
#include "proofs/methods.hpp"
#include "proofs/paper.hpp"
#include "proofs/prover.hpp"
#include "proofs/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::vocabulary;

namespace {

Claim claiming(const Statement& statement) {
  return {.id = "mutant", .place = "test", .printed = {statement}, .prove = by_normal_form()};
}

Outcome decide(const Statement& statement) {
  const Claim claim = claiming(statement);
  Prover nothing_else({});
  return claim.prove(nothing_else, claim);
}

bool confirmed(const Statement& statement, const Witness& witness) {
  return fails_at(claiming(statement), statement, witness);
}

void check_refuted(const Statement& mutant) {
  CAPTURE(text(mutant));
  const Outcome outcome = decide(mutant);
  REQUIRE(outcome.verdict.truth == Truth::refuted);
  CHECK(confirmed(mutant, *outcome.verdict.witness));
}

const Claim& claim(const std::vector<Claim>& claims, const std::string& id) {
  return *std::find_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == id; });
}

}  // namespace

TEST_CASE("a flipped sign in (40), (42) and H(-t)E = EH(t), a swapped index in Lambda") {
  check_refuted(equation(power(H1(t), 2) - I2 + H2(t) * H3(t), 0));
  check_refuted(equation(power(H1(t), 2) + I2 - H2(t) * H3(t), 0));
  check_refuted(equation(power(Gamma1(t), 2) - I2 + Gamma2(t) * Gamma3(t), 0));
  check_refuted(equation(power(Gamma1(t), 2) + I2 - Gamma2(t) * Gamma3(t), 0));
  check_refuted(equation(H(t) * E, E * H(t)));
  check_refuted(equation(H(-t) * E, -E * H(t)));
  check_refuted(equation(Lambda, block(2, {1, 1, lambda2, lambda1})));
  check_refuted(equation(Lambda, block(2, {1, lambda1, 1, lambda2})));
}

TEST_CASE("beside each mutant a rewriting that stays proved") {
  for (const Statement& same :
       {equation(I2 + H3(t) * H2(t), power(H1(t), 2)),
        equation(power(Gamma1(t), 2), I2 + Gamma3(t) * Gamma2(t)), equation(E * H(-t) * E, H(t)),
        equation(Lambda * block(2, {0, 1, 1, 0}), block(2, {1, 1, lambda2, lambda1}))}) {
    CAPTURE(text(same));
    CHECK(decide(same).verdict.truth == Truth::proved);
  }
}

TEST_CASE("every single edit of the identities of Appendix 1 is refuted, or is no change at all") {
  const std::vector<Claim> claims = paper();
  int refuted = 0;
  std::vector<std::string> survivors;
  for (const char* id : {"40", "42", "38", "39", "38.init", "41", "38.ode", "38.group", "38.det",
                         "38.reversal", "41.ode", "41.group", "41.reversal", "39.domain", "39.derived"}) {
    for (const Statement& statement : claim(claims, id).printed) {
      for (const Edit& edit : edits(statement)) {
        CAPTURE(id);
        CAPTURE(edit.what);
        CAPTURE(text(edit.statement));
        const Outcome outcome = decide(edit.statement);
        if (outcome.verdict.truth == Truth::proved) {
          survivors.push_back(std::string(id) + ": " + text(edit.statement));
          continue;
        }
        REQUIRE(outcome.verdict.truth == Truth::refuted);
        CHECK(confirmed(edit.statement, *outcome.verdict.witness));
        ++refuted;
      }
    }
  }
  // No changes at all: H_2 and H_3 both vanish at 0; Sigma gamma_3 = gamma_3, as Sigma differs from I only
  // where gamma_3 vanishes.
  CHECK(survivors == std::vector<std::string>{"38.init: H3(0) = 0", "38.init: H2(0) = 0",
                                              "41: Gamma3(t) = gamma3(t)*Sigma^-1"});
  CHECK(refuted > 200);
}
