// Verdicts that lie are caught, by each engine alone.
#include "proofs/checks/cross_check.hpp"

#include <doctest/doctest.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Proof saying(const Verdict& verdict) {
  return [verdict](Prover&, const Claim&) { return Outcome{.verdict = verdict}; };
}

// A proof that had the printed equation decided, and was told something wrong.
Proof misled(const Verdict& verdict) {
  return [verdict](Prover&, const Claim& claim) {
    Outcome outcome{.verdict = verdict};
    outcome.decided = {{claim.printed.front()}};
    return outcome;
  };
}

Record record(const Statement& printed, const Proof& prove, std::vector<Assumption> assumptions = {}) {
  const std::vector<Claim> claims{{.id = "lie",
                                   .place = "test",
                                   .printed = {printed},
                                   .assumptions = std::move(assumptions),
                                   .prove = prove}};
  return audit(claims, {"lie"}).records.front();
}

Verdict refuted_at(const std::vector<Coordinate>& point) {
  return Verdict::refuted(Witness{point, {}, Ball(0), Ball(1)});
}

const Statement flipped = equation(power(H1(t), 2) - I2 + H2(t) * H3(t), 0);
const Statement right = equation(power(H1(t), 2) - I2 - H2(t) * H3(t), 0);

}  // namespace

TEST_CASE("a wrong equation that is called proved is an internal error that names the claim") {
  for (const Proof& lie : {saying(Verdict::proved()), misled(Verdict::proved())}) {
    CHECK_THROWS_WITH_AS((void)record(flipped, lie), doctest::Contains("claim lie"), InternalError);
  }
  const CrossCheck honest = record(right, saying(Verdict::proved())).outcome.cross_check;
  CHECK(honest.formulas == 1);
  CHECK(honest.exact_points > 0);
  CHECK(honest.ball_points > 0);
}

TEST_CASE("the rational points see what is too small for balls") {
  const Term tiny = power(Term(Rational(1, 10)), 60);
  CHECK_THROWS_WITH_AS((void)record(equation(sin(tau) + tiny, sin(tau)), saying(Verdict::proved())),
                       doctest::Contains("rational point"), InternalError);
}

TEST_CASE("the balls see what has no exact value") {
  CHECK_THROWS_WITH_AS((void)record(equation(sin(tau / 3), cos(tau / 3)), saying(Verdict::proved())),
                       doctest::Contains("in balls"), InternalError);
  const CrossCheck check =
      record(equation(sin(tau / 3), 3 * sin(tau / 9) - 4 * power(sin(tau / 9), 3)), saying(Verdict::proved()))
          .outcome.cross_check;
  CHECK(check.exact_points == 0);
  CHECK(check.ball_points > 0);
  CHECK(check.unchecked.size() > 0);
}

TEST_CASE("a true equation that is called refuted, and a witness that is none, are internal errors") {
  const std::vector<Coordinate> anywhere{{"omega1", Rational(1, 2)}, {"omega2", 2}, {"t", 1}};
  CHECK_THROWS_WITH_AS((void)record(right, misled(refuted_at(anywhere))), doctest::Contains("rational point"),
                       InternalError);
  const Statement at_zero = equation(H2(t) * H3(t), H2(t));  // both are zero at t = 0
  CHECK_THROWS_WITH_AS((void)record(at_zero, misled(refuted_at({{"t", 0}}))), doctest::Contains("witness"),
                       InternalError);
  CHECK(record(at_zero, misled(refuted_at(anywhere))).status == Status::refuted);
}

TEST_CASE(
    "an inequality that is called refuted must fail at the witness, at equality, too, if it is strict") {
  const auto is_refuted_at = [](Relation relation, int value) {
    const Record made = record({V, 0, relation}, misled(refuted_at({{"V", value}})));
    return made.status == Status::refuted && made.outcome.cross_check.ball_points == 1;
  };
  CHECK(is_refuted_at(Relation::greater, 0));
  CHECK(is_refuted_at(Relation::greater, -1));
  CHECK(is_refuted_at(Relation::less, 0));
  CHECK(is_refuted_at(Relation::not_equal, 0));
  CHECK(is_refuted_at(Relation::greater_or_equal, -1));
  CHECK(is_refuted_at(Relation::less_or_equal, 1));
  // Where no ball is a single number.
  const Record at_pi =
      record({cos(pi() * tau), Term(-1), Relation::greater}, misled(refuted_at({{"tau", 1}})));
  CHECK(at_pi.status == Status::refuted);
  for (const auto& [relation, value] : {std::pair{Relation::greater, 1},
                                        {Relation::less, -1},
                                        {Relation::not_equal, 1},
                                        {Relation::greater_or_equal, 0},
                                        {Relation::less_or_equal, 0},
                                        {Relation::less_or_equal, -1}}) {
    CAPTURE(value);
    CHECK_THROWS_WITH_AS((void)record({V, 0, relation}, misled(refuted_at({{"V", value}}))),
                         doctest::Contains("witness"), InternalError);
  }
}

TEST_CASE("values that are assumed are put in, conditions are not evaluated away") {
  const Statement lag = equation(R(tau - t), R(t));
  CHECK_THROWS_AS((void)record(lag, saying(Verdict::proved())), InternalError);
  CHECK(record(lag, saying(Verdict::proved()), {{"lag", equation(phi, -omega * tau / 2)}})
            .outcome.cross_check.exact_points > 0);
  const Proof needs_it = [](Prover&, const Claim&) {
    return Outcome{.verdict = Verdict::proved(), .assumed = {"circle"}};
  };
  const Record conditional = record(equation(z10 * z10, 1 - z20 * z20), needs_it,
                                    {{"circle", equation(power(z10, 2) + power(z20, 2), 1)}});
  CHECK(conditional.outcome.cross_check.formulas == 0);
  CHECK(conditional.outcome.cross_check.unchecked.find("circle") != std::string::npos);
}

TEST_CASE("what holds only under equations is evaluated where they hold") {
  const Assumption at_rest{"rest", equation(zdot0, zero(2, 1))};
  const auto proved = [](const std::set<std::string>& assumed) -> Proof {
    return [assumed](Prover&, const Claim&) {
      return Outcome{.verdict = Verdict::proved(), .assumed = assumed};
    };
  };
  const CrossCheck honest = record(equation(E * Z0, -Z0), proved({"rest"}), {at_rest}).outcome.cross_check;
  CHECK(honest.premise_points > 0);
  CHECK(honest.formulas == 1);
  CHECK_THROWS_WITH_AS((void)record(equation(E * Z0, Z0), proved({"rest"}), {at_rest}),
                       doctest::Contains("all that it rests on holds"), InternalError);
  // What cannot be evaluated may be the very premise that excludes the point.
  const Assumption of_motion{"motion", equation(Function{"Y", {2, 1}}(tau), z0)};
  const CrossCheck open =
      record(equation(E * Z0, Z0), proved({"rest", "motion"}), {at_rest, of_motion}).outcome.cross_check;
  CHECK(open.premise_points == 0);
  CHECK(open.unchecked.find("motion") != std::string::npos);
}

TEST_CASE("every identity of Appendices 1 and 3 is looked at by both engines") {
  const std::vector<Claim> claims = paper().claims;
  std::set<std::string> ids = ids_named(claims, "A1");
  ids.merge(ids_named(claims, "A3"));
  ids.erase("39.frequencies");  // says that something exists
  ids.erase("39.data");         // the same
  ids.erase("39.range");        // inequalities
  for (const Record& one : audit(claims, ids).records) {
    CAPTURE(one.claim.id);
    CHECK(one.outcome.cross_check.exact_points > 0);
    CHECK(one.outcome.cross_check.ball_points > 0);
    CHECK(one.outcome.cross_check.unchecked == "");
  }
}
