#include "proofs/methods/prover.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <functional>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/methods/status.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

// Proved by some theorem.
Proof verdict(const Verdict& given, const std::set<std::string>& uses = {}) {
  return [=](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = given;
    outcome.uses = uses;
    if (given.truth == Truth::proved) {
      outcome.theorems = {proofs::kernel::Theorem::reflexive(1)};
      outcome.by_kernel = true;
    }
    return outcome;
  };
}

Proof in_balls(const std::set<std::string>& uses = {}, const std::vector<Coordinate>& at = {}) {
  return [=](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    outcome.uses = uses;
    outcome.at = at;
    return outcome;
  };
}

Claim claim(const std::string& id, const Proof& proof, Kind kind = Kind::step) {
  return {.id = id, .place = "test", .kind = kind, .prove = proof};
}

}  // namespace

TEST_CASE("a status follows from the verdicts of the claim and of all that it uses") {
  const std::vector<Claim> claims{claim("good", verdict(Verdict::proved())),
                                  claim("bad", verdict(Verdict::refuted("no"))),
                                  claim("open", verdict(Verdict::undecided("perhaps"))),
                                  claim("number", verdict(Verdict::refuted("off")), Kind::numbers),
                                  claim("given", {}, Kind::model),
                                  claim("on good", verdict(Verdict::proved(), {"good", "given"})),
                                  claim("on bad", verdict(Verdict::proved(), {"good", "bad"})),
                                  claim("on open", verdict(Verdict::proved(), {"open"})),
                                  claim("far from open", verdict(Verdict::proved(), {"on open"}))};
  CHECK(status(claims, "good") == Status::as_printed);
  CHECK(status(claims, "bad") == Status::refuted);
  CHECK(status(claims, "open") == Status::undecided);
  CHECK(status(claims, "number") == Status::digits_off);
  CHECK(status(claims, "given") == Status::model);
  CHECK(status(claims, "on good") == Status::as_printed);
  CHECK(status(claims, "on bad") == Status::rests_on_unproved);
  CHECK(status(claims, "on open") == Status::rests_on_unproved);
  CHECK(status(claims, "far from open") == Status::rests_on_unproved);
  CHECK(audit(claims).records[0].used_by == std::set<std::string>{"on bad", "on good"});
}

TEST_CASE("what is proved without a theorem says so") {
  const Claim balls = claim("balls", in_balls());
  CHECK(status({balls}, "balls") == Status::decided_in_balls);
  CHECK(status({balls, claim("user", verdict(Verdict::proved(), {"balls"}))}, "user") == Status::as_printed);
}

TEST_CASE("only what the paper prints is proved as printed") {
  for (const OriginFacts& row : origins()) {
    CAPTURE(row.name);
    Claim one = claim("one", verdict(Verdict::proved()));
    one.origin = row.origin;
    CHECK(status({one}, "one") == (row.origin == Origin::paper ? Status::as_printed : Status::proved));
    one.prove = verdict(Verdict::undecided("perhaps"));
    CHECK(status({one}, "one") == Status::undecided);
    one.prove = verdict(Verdict::refuted("no"));
    CHECK(status({one}, "one") == Status::refuted);
  }
}

TEST_CASE("a misprint is one only if the corrected form is proved") {
  Claim misprint = claim("m", verdict(Verdict::refuted("no")));
  misprint.prove_corrected = verdict(Verdict::proved());
  CHECK(status({misprint}, "m") == Status::misprint_corrected);
  misprint.prove_corrected = verdict(Verdict::undecided("perhaps"));
  CHECK(status({misprint}, "m") == Status::refuted);
  misprint.prove = verdict(Verdict::proved());
  CHECK(status({misprint}, "m") == Status::as_printed);
}

TEST_CASE("circular proofs, unknown and doubled ids are internal errors") {
  const std::vector<Claim> circle{claim("a", verdict(Verdict::proved(), {"b"})),
                                  claim("b", verdict(Verdict::proved(), {"a"}))};
  CHECK_THROWS_WITH_AS((void)audit(circle), doctest::Contains("uses itself"), InternalError);
  CHECK_THROWS_AS((void)audit({claim("a", verdict(Verdict::proved(), {"c"}))}), InternalError);
  CHECK_THROWS_AS((void)audit({claim("a", verdict(Verdict::proved()))}, {"z"}), InternalError);
  CHECK_THROWS_AS((void)audit({circle[0], circle[0]}), InternalError);
}

TEST_CASE("hypotheses are inherited, but not where the data meet them") {
  Claim resonant{
      .id = "r",
      .place = "test",
      .printed = {equation((power(omega, 2) - power(omega1, 2)) / (omega - omega1), omega + omega1)},
      .prove = by_normal_form()};
  const std::vector<Claim> claims{
      resonant, claim("user", in_balls({"r"})),
      claim("at data", in_balls({"r"}, {{"chi", Rational(1, 2)}, {"eta", 2}, {"omega", Rational(1, 3)}}))};
  CHECK(status(claims, "r") == Status::where_defined);
  CHECK(status(claims, "user") == Status::where_defined);
  CHECK(audit(claims, {"user"}).records.front().outcome.hypotheses.size() == 1);
  CHECK(status(claims, "at data") == Status::decided_in_balls);
  // No one who reads the paper sees a formula of ours.
  std::vector<Claim> ours = claims;
  ours[0].origin = Origin::auxiliary;
  CHECK(status(ours, "r") == Status::where_defined);
  CHECK(status(ours, "user") == Status::needs_hypotheses);
}

TEST_CASE("a premise's own assumptions must be assumed, and stay as they were") {
  const Assumption lag{"lag", equation(phi, -omega * tau / 2)};
  const Claim reversed{.id = "F",
                       .place = "test",
                       .printed = {equation(R(tau - t), R(t))},
                       .assumptions = {lag},
                       .prove = by_normal_form()};
  Claim user{.id = "user",
             .place = "test",
             .printed = {equation(R(tau - s), R(s))},
             .assumptions = {lag},
             .prove = by_rewriting({from("F").at("t", s)})};
  const auto with_paper = [&] {
    std::vector<Claim> claims = paper().claims;
    claims.push_back(reversed);
    claims.push_back(user);
    return claims;
  };
  CHECK(status(with_paper(), "F") == Status::as_printed);
  CHECK(status(with_paper(), "user") == Status::as_printed);
  user.assumptions.clear();
  CHECK(status(with_paper(), "user") == Status::refuted);
  user.assumptions = {lag};
  user.prove = by_rewriting({from("F").at("tau", s)});
  CHECK(status(with_paper(), "user") == Status::undecided);
}

TEST_CASE("what contradicts itself proves nothing") {
  Claim twice{.id = "2t",
              .place = "test",
              .printed = {{2 * tau, 0, Relation::greater}},
              .assumptions = {{"+", {tau, 0, Relation::greater}}},
              .prove = by_positive_combination({{.positive = {{2, {{assuming("+")}}}}}})};
  const auto verdict_now = [&] { return audit({twice}).records.front().outcome.verdict; };
  CHECK(verdict_now().truth == Truth::proved);
  twice.assumptions.push_back({"-", {tau, 0, Relation::less}});
  CHECK(verdict_now().truth == Truth::undecided);
  CHECK(verdict_now().reason.find("vacuous") == 0);
}

namespace {

Outcome zero_is_zero() {
  Outcome outcome;
  outcome.verdict = Verdict::proved();
  outcome.theorems = {proofs::kernel::Theorem::combination(proofs::kernel::equal(0, 0))};
  return outcome;
}

// Claims "c0", "c1", …, each proved after those that `needs` names.
std::vector<Claim> chained(int count, const std::function<std::vector<int>(int)>& needs,
                           std::vector<std::atomic<int>>& proofs) {
  std::vector<Claim> result;
  for (int k = 0; k < count; ++k) {
    result.push_back({.id = "c" + std::to_string(k),
                      .place = "test",
                      .printed = {equation(0, 0)},
                      .prove = [k, needs, &proofs](Prover& prover, const Claim&) {
                        for (const int one : needs(k)) {
                          static_cast<void>(prover.prove("c" + std::to_string(one)));
                        }
                        ++proofs[static_cast<std::size_t>(k)];
                        Outcome outcome = zero_is_zero();
                        outcome.by_kernel = true;
                        return outcome;
                      }});
  }
  return result;
}

}  // namespace

TEST_CASE("several threads prove each claim once") {
  constexpr int count = 200;
  std::vector<std::atomic<int>> proofs(count);
  const Jobs threads(4);
  const Audit whole = audit(chained(
      count,
      [](int k) {
        return k == 0 ? std::vector<int>{} : std::vector<int>{k / 2, k - 1};
      },
      proofs));
  REQUIRE(whole.records.size() == count);
  for (const Record& record : whole.records) {
    CHECK(record.status == Status::as_printed);
  }
  CHECK(std::ranges::all_of(proofs, [](const std::atomic<int>& times) { return times == 1; }));
}

TEST_CASE("proofs that use themselves by way of another thread are refused, and nothing waits for ever") {
  const Jobs threads(4);
  for (int time = 0; time < 50; ++time) {
    std::vector<std::atomic<int>> proofs(8);
    CHECK_THROWS_AS((void)audit(chained(
                        8, [](int k) { return std::vector<int>{(k + 3) % 8}; }, proofs)),
                    InternalError);
  }
}
