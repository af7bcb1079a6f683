#include <doctest/doctest.h>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Record record(const Claim& claim) {
  std::vector<Claim> claims = paper().claims;
  claims.push_back(claim);
  return audit(claims, {claim.id}).records.front();
}

Claim claim(const Statement& printed, const std::vector<Assumption>& assumptions,
            const Proof& prove = by_normal_form()) {
  return {.id = "one", .place = "test", .printed = {printed}, .assumptions = assumptions, .prove = prove};
}

}  // namespace

TEST_CASE("what fails where the assumptions do not hold is not refuted") {
  const Statement square = equation(power(cos(tau), 2), 1);
  CHECK(record(claim(square, {})).status == Status::refuted);
  CHECK(record(claim(square, {{"sine", equation(sin(tau), 0)}})).status == Status::undecided);
  const Statement at_period = equation(Z(Theta), Z0);
  CHECK(record(claim(square, {{"period", at_period}})).status == Status::undecided);
}

TEST_CASE("what fails where the values and the inequalities of the assumptions hold is refuted") {
  const Statement half = equation(sin(omega * tau) * cos(omega * tau), 3);
  CHECK(record(claim(half, {{"tau", equation(tau, pi() / omega)}})).status == Status::refuted);
  CHECK(record(claim(half, {{"tau", {tau, 0, Relation::greater}}})).status == Status::refuted);
  const Record negative =
      record(claim(half, {{"tau", {tau, 0, Relation::less}}, {"t", {tau, 0, Relation::greater}}}));
  CHECK(negative.status == Status::undecided);
}

TEST_CASE("a claim that prints nothing is no theorem") {
  Claim silent = claim(equation(tau, tau), {}, by_kernel("nothing to prove", [](Derivation& d, std::size_t) {
                         return d.follows(d.read(equation(tau, tau)));
                       }));
  silent.printed.clear();
  const Record silence = record(silent);
  CHECK(silence.status == Status::undecided);
  CHECK(silence.outcome.theorems.empty());
}

TEST_CASE("a definition of what has a meaning in the model must be a theorem") {
  const Status right = record(claim(equation(xi1, ZB - FB + E * (Z0 - F0)), {}, by_definition())).status;
  const Status wrong = record(claim(equation(xi1, ZB - FB - E * (Z0 - F0)), {}, by_definition())).status;
  CHECK(right == Status::as_printed);
  CHECK(wrong != Status::as_printed);
  CHECK(wrong != Status::needs_hypotheses);
}
