#include "proofs/methods/motions.hpp"

#include <doctest/doctest.h>

#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/methods/status.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Truth verdict(const Claim& claim) {
  std::vector<Claim> claims = paper().claims;
  claims.push_back(claim);
  return audit(claims, {claim.id}).records.front().outcome.verdict.truth;
}

// The paper with one claim changed.
std::vector<Claim> paper_with(const std::string& id, const std::function<void(Claim&)>& change) {
  std::vector<Claim> claims = paper().claims;
  for (Claim& claim : claims) {
    if (claim.id == id) {
      change(claim);
    }
  }
  return claims;
}

std::function<void(Claim&)> without(const std::string& assumption) {
  return [assumption](Claim& claim) {
    std::erase_if(claim.assumptions, [&](const Assumption& one) { return one.id == assumption; });
  };
}

// What the paper assumes under that id.
Assumption assumed(const std::string& id) {
  for (const Claim& claim : paper().claims) {
    for (const Assumption& one : claim.assumptions) {
      if (one.id == id) {
        return one;
      }
    }
  }
  throw InternalError("nothing is assumed as " + id);
}

const Term speed = block(1, {0, 0, 0, 1});

// z2(tau) - z2(0) < bound tau from x2' < bound.
Claim mean_value(const Term& bound, const Statement& printed) {
  return {.id = "mean",
          .place = "test",
          .printed = {printed},
          .assumptions = {assumed("2.slip"),
                          assumed("6.Z0"),
                          assumed("tau.positive"),
                          assumed("28.ZB"),
                          {"slope", during(0, tau, {speed * X(t), bound, Relation::less})}},
          .prove = by_mean_value({.phase = "2.slip",
                                  .slope = "slope",
                                  .begins = "6.Z0",
                                  .ends = "28.ZB",
                                  .lasts = "tau.positive",
                                  .row = block(1, {0, 1, 0, 0})})};
}

}  // namespace

TEST_CASE("the mean value theorem gives its own bound and no other") {
  // By the method alone: no motion is known here that obeys a bound at all times.
  const auto found = [](const Claim& claim) {
    Prover prover(paper().claims);
    return claim.prove(prover, claim).verdict.truth;
  };
  CHECK(found(mean_value(V, {z2B - z20, V * tau, Relation::less})) == Truth::proved);
  CHECK(found(mean_value(V, {z20 - z2B, V * tau, Relation::less})) == Truth::undecided);
  CHECK(found(mean_value(V, {z2B - z20, 2 * V * tau, Relation::less})) == Truth::undecided);
  CHECK(found(mean_value(V, {z1B - z20, V * tau, Relation::less})) == Truth::undecided);
  CHECK(found(mean_value(V * t, {z2B - z20, V * tau, Relation::less})) == Truth::undecided);
}

TEST_CASE("a closed form is that of a motion which obeys the equation, on its interval") {
  const std::vector<Claim> claims = paper().claims;
  CHECK(status(claims, "5") == Status::where_defined);
  for (const char * assumption : {"2.slip", "6.Z0", "t.from", "t.to"}) {
    CAPTURE(assumption);
    CHECK(status(paper_with("5", without(assumption)), "5") == Status::undecided);
  }
  // Under another friction, of another flow, with another start.
  CHECK(status(paper_with("5",
                          [](Claim& claim) {
                            const Statement slips = assumed("2.slip").statement;
                            claim.assumptions[0] = {
                                "2.slip",
                                during(0, tau,
                                       equation(slips.left, slips.right - column({0, 0, 0, 2 * eta * us})))};
                          }),
               "5") == Status::undecided);
  CHECK(status(paper_with("5",
                          [](Claim& claim) {
                            claim.printed = {equation(Z(t), Gamma(t) * (Z0 - F0) + F(t))};
                            claim.prove = by_differential_equation({"2.slip", "6.Z0", Gamma(t), F(t)});
                          }),
               "5") == Status::undecided);
  CHECK(status(paper_with("5",
                          [](Claim& claim) {
                            claim.assumptions[1] = {"6.Z0", equation(Z(tau), Z0)};
                          }),
               "5") == Status::undecided);
}

TEST_CASE("two closed forms are of two motions: no letter ties a slip to an overshoot") {
  // From (5) and (8) of one motion, without the interval of either, L(t) d_0 = 0 would follow.
  const Claim both{.id = "both",
                   .place = "test",
                   .printed = {equation(L(t) * d0, zero(4, 1))},
                   .assumptions = {assumed("6.Z0")},
                   .prove = by_rewriting({from("8").solved_for(L(t) * d0), from("5")})};
  CHECK(verdict(both) == Truth::undecided);
}

TEST_CASE("what takes the place of an assumption must say just that, and its own assumptions count") {
  const auto another =
      paper_with("A5.second", [](Claim& claim) { claim.printed = {equation(tau1, pi() / omega1)}; });
  CHECK(status(another, "A5.theorem") == Status::undecided);
  CHECK(status(paper_with("A5.theorem", without("25.slope")), "A5.theorem") == Status::undecided);
  const auto unsupplied =
      paper_with("A5.theorem", [](Claim& claim) { claim.prove = by_premises({from("69.motion")}); });
  CHECK(status(unsupplied, "A5.theorem") == Status::undecided);
  const auto too_much =
      paper_with("A5.theorem", [](Claim& claim) { claim.printed.push_back(equation(X(t), X(t + tau))); });
  CHECK(status(too_much, "A5.theorem") == Status::undecided);
}

TEST_CASE("the theorem of Appendix 5 needs no more than it says") {
  const std::vector<Claim> claims = paper().claims;
  CHECK(status(claims, "A5.theorem") == Status::as_printed);
  CHECK(status(claims, "A5.unique") == Status::proved);
  CHECK(status(claims, "A5.symmetry") == Status::proved);
}
