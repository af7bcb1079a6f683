#include "proofs/methods/implications.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/checks/mutants.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Record proved(const Claim& claim) {
  const std::vector<Claim> claims{claim,
                                  {.id = "39", .place = "test", .kind = Kind::model},
                                  {.id = "38", .place = "test", .kind = Kind::model}};
  return audit(claims, {claim.id}).records.front();
}

const Assumption a_is_one{"a", equation(2 * z10, us)};
const Assumption positive{"+", {z10, 0, Relation::greater}};

}  // namespace

TEST_CASE("a combination that comes out proves, another one decides nothing") {
  Claim claim{.id = "c",
              .place = "test",
              .printed = {equation(z10, us / 2)},
              .assumptions = {a_is_one},
              .prove = by_combination({{{assuming("a"), 0, Term(Rational(1, 2))}}})};
  CHECK(proved(claim).status == Status::as_printed);
  CHECK(proved(claim).outcome.assumed == std::set<std::string>{"a"});
  claim.prove = by_combination({{{assuming("a")}}});
  CHECK(proved(claim).outcome.verdict.truth == Truth::undecided);
}

TEST_CASE("an inequality needs positive coefficients and a strict premise") {
  Claim claim{.id = "c",
              .place = "test",
              .printed = {{us * z10, 0, Relation::greater}},
              .assumptions = {positive},
              .prove = by_positive_combination({{.positive = {{us, {{assuming("+")}}}}}})};
  CHECK(proved(claim).status == Status::as_printed);
  claim.printed = {{-us * z10, 0, Relation::greater}};
  claim.prove = by_positive_combination({{.positive = {{-us, {{assuming("+")}}}}}});
  CHECK(proved(claim).outcome.verdict.truth == Truth::refuted);
  claim.printed = {{z20 * z10, 0, Relation::greater}};
  claim.prove = by_positive_combination({{.positive = {{z20, {{assuming("+")}}}}}});
  CHECK(proved(claim).outcome.verdict.truth == Truth::refuted);
  claim.assumptions = {{"+", {z10, 0, Relation::greater_or_equal}}};
  claim.printed = {{us * z10, 0, Relation::greater}};
  claim.prove = by_positive_combination({{.positive = {{us, {{assuming("+")}}}}}});
  CHECK(proved(claim).outcome.verdict.truth == Truth::refuted);
}

TEST_CASE("squares are positive where they are not zero, which is recorded") {
  const Claim claim{.id = "c",
                    .place = "test",
                    .printed = {{power(z20, 2) * z10, 0, Relation::greater}},
                    .assumptions = {positive},
                    .prove = by_positive_combination({{.positive = {{power(z20, 2), {{assuming("+")}}}}}})};
  CHECK(proved(claim).status == Status::needs_hypotheses);
  CHECK(proved(claim).outcome.hypotheses.front().text == "z20 != 0");
}

TEST_CASE("a hypothesis that the claim states is no finding") {
  Claim claim{.id = "c",
              .place = "test",
              .printed = {equation(sin(2 * tau) / sin(tau), 2 * cos(tau))},
              .prove = by_normal_form()};
  CHECK(proved(claim).status == Status::where_defined);
  claim.assumptions = {{"s", {sin(2 * tau), 0, Relation::not_equal}}};
  CHECK(proved(claim).status == Status::as_printed);
  CHECK(proved(claim).outcome.assumed == std::set<std::string>{"s"});
  claim.assumptions = {{"s", {cos(tau), 0, Relation::not_equal}}};
  CHECK(proved(claim).status == Status::where_defined);
}

TEST_CASE("a hypothesis is visible where the formula divides by what it keeps from zero, and only there") {
  const auto status = [](const Statement& printed) {
    return proved({.id = "c",
                   .place = "test",
                   .printed = {printed},
                   .assumptions = {{"double", equation(z10 * z20, z20)}},
                   .prove = by_combination({{{assuming("double"), 0, 1 / z20}}})})
        .status;
  };
  CHECK(status(equation(z10, 1)) == Status::needs_hypotheses);
  CHECK(status(equation(z10 - 1 / power(z20, 2), 1 - 1 / power(z20, 2))) == Status::where_defined);
  CHECK(status(equation(z10 - 1 / us, 1 - 1 / us)) == Status::needs_hypotheses);
}

TEST_CASE("what says no more than it assumes is a premise, and as printed with one word more") {
  Claim claim{.id = "c", .place = "test", .printed = {positive.statement}, .assumptions = {positive}};
  claim.prove = by_premises({assuming("+")});
  CHECK(proved(claim).status == Status::premise);
  claim.printed = {{2 * z10, 0, Relation::greater}};
  claim.prove = by_positive_combination({{.positive = {{2, {{assuming("+")}}}}}});
  CHECK(proved(claim).status == Status::as_printed);
}

TEST_CASE("a misprint is repaired by the single edits that are proved") {
  const Claim claim{.id = "c",
                    .place = "test",
                    .printed = {equation(power(H1(t), 2) - I2 + H2(t) * H3(t), 0)},
                    .prove = by_normal_form()};
  const Record record = proved(claim);
  CHECK(record.status == Status::misprint_corrected);
  REQUIRE(record.repairs.size() == 1);
  CHECK(text(record.repairs.front().statement) == "H1^2(t) - I - H2(t)*H3(t) = 0");
  CHECK(text(record.claim.corrected.front()) == text(record.repairs.front().statement));
}

TEST_CASE("a converse that fails makes a condition necessary only") {
  Claim claim{.id = "c",
              .place = "test",
              .printed = {{us * z10, 0, Relation::greater}},
              .assumptions = {positive},
              .prove = by_positive_combination({{.positive = {{us, {{assuming("+")}}}}}}),
              .prove_converse = [](Prover&, const Claim&) {
                Outcome outcome;
                outcome.verdict = Verdict::refuted("no");
                return outcome;
              }};
  CHECK(proved(claim).status == Status::necessary_not_sufficient);
}

TEST_CASE("the only zero of a cosine between two ends") {
  const auto up_to = [](int periods, const Rational& half_turns) {
    return Claim{.id = "c",
                 .place = "test",
                 .printed = {equation(tau, pi() / omega)},
                 .assumptions = {{"0", equation(cos(omega * tau / 2), 0)},
                                 {"from", {tau, 0, Relation::greater}},
                                 {"to", {tau, 2 * periods * pi() / omega, Relation::less}}},
                 .prove = by_zero_of_cosine({omega * tau / 2, assuming("0"), 0, half_turns})};
  };
  CHECK(proved(up_to(1, 1)).status == Status::as_printed);
  CHECK(proved(up_to(2, 2)).outcome.verdict.truth == Truth::undecided);  // there is another zero
  CHECK(proved(up_to(2, 1)).outcome.verdict.truth == Truth::undecided);  // it is not in that range
  Claim anywhere = up_to(1, 1);
  anywhere.assumptions.pop_back();
  CHECK(proved(anywhere).outcome.verdict.truth == Truth::undecided);
}

TEST_CASE("nonzero follows from nonzero only by a multiple of it") {
  const auto claim = [](const Term& printed, const Term& assumed, const Term& multiplier) {
    return proved({.id = "c",
                   .place = "test",
                   .printed = {{printed, 0, Relation::not_equal}},
                   .assumptions = {{"given", {assumed, 0, Relation::not_equal}}},
                   .prove = by_nonzero_multiple("given", multiplier)})
        .outcome.verdict.truth;
  };
  const Term squares = power(omega, 2) - power(omega1, 2);
  CHECK(claim(omega - omega1, squares, squares * (omega + omega1)) == Truth::proved);
  CHECK(claim(omega - omega1, squares, squares) == Truth::undecided);
  CHECK(claim(sin(tau), cos(tau), 1) == Truth::refuted);
}
