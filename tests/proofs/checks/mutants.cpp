// A wrong statement must be refuted, and its witness must hold up in an evaluation that knows no kernel.
#include <doctest/doctest.h>

#include "proofs/checks/cross_check.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::checks;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Claim claiming(const Statement& statement) {
  return {.id = "mutant", .place = "test", .printed = {statement}, .prove = by_normal_form()};
}

Outcome decide(const Statement& statement) {
  const Claim claim = claiming(statement);
  Prover nothing_else({});
  Outcome outcome = claim.prove(nothing_else, claim);
  look_for_witness(outcome, nothing_else, claim);
  return outcome;
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
