#include "proofs/methods/calculus.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

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

const Term place = block(1, {0, 1, 0, 0});

// z2(tau) - z2(0) < bound tau from z2' < slope.
Claim mean_value(const Term& slope, const Statement& printed) {
  return {.id = "mean",
          .place = "test",
          .printed = {printed},
          .assumptions = {{"slope", {derivative(place * Z(t)), slope, Relation::less}},
                          {"ZB", equation(Z(tau), ZB)}},
          .prove = by_mean_value(
              {.slope = "slope", .named = "ZB", .row = place, .at_lower = Z0, .at_upper = ZB, .upper = tau})};
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

Status status(const std::vector<Claim>& claims, const std::string& id) {
  return audit(claims, {id}).records.front().status;
}

}  // namespace

TEST_CASE("the mean value theorem gives its own bound and no other") {
  CHECK(verdict(mean_value(V, {z2B - z20, V * tau, Relation::less})) == Truth::proved);
  CHECK(verdict(mean_value(V, {z20 - z2B, V * tau, Relation::less})) == Truth::undecided);
  CHECK(verdict(mean_value(V, {z2B - z20, 2 * V * tau, Relation::less})) == Truth::undecided);
  CHECK(verdict(mean_value(V, {z1B - z20, V * tau, Relation::less})) == Truth::undecided);
  CHECK_THROWS_AS((void)verdict(mean_value(V * t, {z2B - z20, V * tau, Relation::less})), InternalError);
}

TEST_CASE("a rate that is not minus a positive multiple of a square proves nothing") {
  for (const char * link : {"A5.energy", "A5.sign", "A5.weight"}) {
    CAPTURE(link);
    const auto broken = paper_with(link, [](Claim& claim) {
      claim.prove = [](Prover&, const Claim&) { return Outcome{.verdict = Verdict::undecided("broken")}; };
    });
    CHECK(status(broken, "A5.sides") == Status::rests_on_unproved);
    CHECK(status(broken, "A5.unique") == Status::rests_on_unproved);
  }
  const auto growing = paper_with("A5.sign", [](Claim& claim) {
    claim.printed = {equation(claim.printed.front().left, -claim.printed.front().right)};
  });
  CHECK(audit(growing, {"A5.sides"}).records.front().outcome.verdict.truth == Truth::undecided);
}

TEST_CASE("a claim that takes the place of an assumption must say just that, and its own assumptions count") {
  const auto other =
      paper_with("A5.second", [](Claim& claim) { claim.printed = {equation(tau1, pi() / omega1)}; });
  CHECK_THROWS_WITH_AS((void)audit(other, {"A5.theorem"}), doctest::Contains("does not say"), InternalError);
  const auto without_slope = paper_with("A5.theorem", [](Claim& claim) {
    std::erase_if(claim.assumptions, [](const Assumption& a) { return a.id == "25.slope"; });
  });
  CHECK_THROWS_WITH_AS((void)audit(without_slope, {"A5.theorem"}), doctest::Contains("25.slope"),
                       InternalError);
  const auto unsupplied =
      paper_with("A5.theorem", [](Claim& claim) { claim.prove = by_premises({from("69.motion")}); });
  CHECK_THROWS_AS((void)audit(unsupplied, {"A5.theorem"}), InternalError);
  const auto too_much =
      paper_with("A5.theorem", [](Claim& claim) { claim.printed.push_back(equation(X(t), X(t + tau))); });
  CHECK(status(too_much, "A5.theorem") == Status::undecided);
}

TEST_CASE("nonzero follows from nonzero only by divisibility") {
  const auto claim = [](const Term& printed, const Term& assumed) {
    return Claim{.id = "nonzero",
                 .place = "test",
                 .printed = {{printed, 0, Relation::not_equal}},
                 .assumptions = {{"given", {assumed, 0, Relation::not_equal}}},
                 .prove = by_nonzero_multiple("given")};
  };
  CHECK(verdict(claim(omega - omega1, power(omega, 2) - power(omega1, 2))) == Truth::proved);
  CHECK(verdict(claim(omega - omega1, sin(pi() * omega1 / omega))) == Truth::proved);
  CHECK(verdict(claim(omega - omega1, cos(pi() * omega1 / omega))) == Truth::undecided);
  CHECK(verdict(claim(power(omega, 2) - power(omega1, 2), omega - omega1)) == Truth::undecided);
}

TEST_CASE("the theorem of Appendix 5 needs no more than it says") {
  const std::vector<Claim> claims = paper().claims;
  for (const char * id : {"A5.theorem", "A5.unique", "A5.symmetry"}) {
    CAPTURE(id);
    CHECK(status(claims, id) == Status::as_printed);
  }
}
