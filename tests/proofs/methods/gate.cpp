// Claims that are not so, or say nothing, put to every method: none may be called proved, and none that is so
// refuted.
#include "proofs/methods/gate.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/methods.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::methods {
namespace {

using namespace symbols;
using namespace symbols::vocabulary;

// With the paper's own claims, for what it speaks of is defined there.
Record record(const Claim& claim) {
  static const std::vector<Claim> known = pascal2012::paper().claims;
  std::vector<Claim> claims = known;
  claims.push_back(claim);
  return audit(claims, {claim.id}).records.back();
}

// Refused: by a verdict, or by the gate.
bool is_not_proved(const Claim& claim) {
  try {
    return !facts(record(claim).status).stands;
  } catch (const InternalError&) {
    return true;
  }
}

Claim defining(const std::vector<Statement>& printed) {
  return {.id = "definition",
          .place = "test",
          .kind = Kind::definition,
          .printed = printed,
          .prove = by_definition()};
}

Claim assuming_all(const std::vector<Statement>& assumed, const Statement& printed) {
  Claim claim{.id = "claim", .place = "test", .printed = {printed}, .prove = by_normal_form()};
  for (const Statement& one : assumed) {
    claim.assumptions.push_back({"a" + std::to_string(claim.assumptions.size()), one});
  }
  return claim;
}

}  // namespace

TEST_CASE("what is called a definition is a theorem, or no claim") {
  CHECK(is_not_proved(defining({equation(pi(), 3)})));
  CHECK(is_not_proved(defining({equation(cos(t), 2)})));
  CHECK(is_not_proved(defining({equation(H(t), zero(4, 4))})));
  CHECK(is_not_proved(defining({{chi, 0, Relation::less}})));
  CHECK(is_not_proved(defining({equation(tau, 1), equation(tau, 2)})));
  CHECK(is_not_proved(defining({equation(tau, 1)})));
  CHECK(is_not_proved(defining({equation(xi1, ZB)})));
  const Record right = record(defining({equation(xi1, ZB - FB + E * (Z0 - F0))}));
  CHECK(right.status == Status::as_printed);
  CHECK(right.outcome.theorems.size() == 1);
  Claim taken = defining({equation(tau, 1)});
  taken.prove = {};
  CHECK(record(taken).status == Status::model);
}

TEST_CASE("a root that one statement speaks of is no number for another") {
  const Statement positive{tau, 0, Relation::greater_or_equal};
  const Statement of_root = equation(power(sqrt(tau), 2), tau);
  // tau >= 0 from sqrt(tau)^2 = tau, of a claim that states both.
  const auto by_the_root = [&](Prover& prover, const Claim& claim) {
    Outcome outcome{.verdict = Verdict::proved(), .by_kernel = true};
    Derivation derivation(prover, claim);
    const kernel::Theorem square = kernel::Theorem::assume(derivation.read(of_root));
    const kernel::Term root = square.conclusion().parts()[0].parts()[0];
    outcome.theorems = {
        kernel::Theorem::order(derivation.printed(0), {kernel::Positive{{}, 1, root}}, {{square, -1}}),
        square};
    return outcome;
  };
  Claim both = saying({.id = "both", .place = "test", .prove = by_the_root}, {positive, of_root});
  CHECK_THROWS_AS(record(both), InternalError);
  // So it may be where what is assumed speaks of the root.
  both.assumptions.push_back({"a", {sqrt(tau), 1, Relation::less}});
  CHECK(facts(record(saying(both, {positive, of_root})).status).stands);
}

TEST_CASE("a comparison of something else, or of less, proves nothing that is printed") {
  const auto comparing = [](const std::vector<Statement>& printed, const Compare& compare) {
    return Claim{.id = "compared",
                 .place = "test",
                 .printed = printed,
                 .prove = [compare](Prover& prover, const Claim& claim) {
                   return compared("", prover, claim, compare);
                 }};
  };
  const kernel::Term x = kernel::Variable{"tau"};
  const Compare trivial = [=](Derivation&) { return std::vector<Equal>{{x, x}}; };
  const Compare nothing = [](Derivation&) { return std::vector<Equal>{}; };
  CHECK(is_not_proved(comparing({equation(X(0), zero(4, 1))}, trivial)));
  CHECK(is_not_proved(comparing({equation(X(0), zero(4, 1))}, nothing)));
  CHECK(is_not_proved(comparing({}, nothing)));
  CHECK(is_not_proved(comparing({equation(tau, 1)}, trivial)));
  // All rows and columns are looked at.
  const auto of = [](int entry) { return kernel::matrix(2, 2, {1, 0, 0, entry}); };
  CHECK(is_not_proved(comparing({}, [=](Derivation&) { return std::vector<Equal>{{of(1), of(2)}}; })));
  CHECK(is_not_proved(comparing({}, [=](Derivation&) {
    return std::vector<Equal>{{kernel::matrix(1, 2, {1, 0}), kernel::matrix(1, 2, {1, 2})}};
  })));
  CHECK(is_not_proved(comparing({}, [=](Derivation&) {
    return std::vector<Equal>{{kernel::matrix(2, 1, {1, 0}), kernel::matrix(1, 2, {1, 0})}};
  })));
  CHECK(facts(record(comparing({},
                               [=](Derivation&) {
                                 return std::vector<Equal>{{of(1), of(1)}};
                               }))
                  .status)
            .stands);
}

TEST_CASE("a theorem made elsewhere has to be the one that is printed") {
  const Claim claim{.id = "one",
                    .place = "test",
                    .printed = {equation(X(0), zero(4, 1))},
                    .prove = by_theorem("", [] { return kernel::Theorem::reflexive(1); })};
  CHECK_THROWS_AS(record(claim), InternalError);
  // A method that says "proved" and has nothing, or something else, to show.
  Claim forged{
      .id = "two", .place = "test", .printed = {equation(tau, 1)}, .prove = [](Prover&, const Claim&) {
        Outcome outcome;
        outcome.verdict = Verdict::proved();
        outcome.by_kernel = true;
        return outcome;
      }};
  CHECK_THROWS_AS(record(forged), InternalError);
  forged.prove = [](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    return outcome;  // in balls, it seems
  };
  CHECK_THROWS_AS(record(forged), InternalError);
  // A theorem beside a verdict that is not its own.
  forged.prove = [](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    outcome.theorems = {kernel::Theorem::reflexive(1)};
    return outcome;
  };
  CHECK_THROWS_AS(record(forged), InternalError);
  // Under a hypothesis that the claim does not make, and that nobody is told of; in words, too.
  forged.prove = [](Prover& prover, const Claim& claim) {
    Derivation derivation(prover, claim);
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    outcome.by_kernel = true;
    outcome.theorems = {kernel::Theorem::assume(derivation.read(claim.printed[0]))};
    return outcome;
  };
  CHECK_THROWS_AS(record(forged), InternalError);
  forged.prove = [](Prover&, const Claim&) {
    Outcome outcome;
    outcome.verdict = Verdict::proved();
    outcome.by_kernel = true;
    outcome.theorems = {kernel::Theorem::assume(equal(kernel::Variable{"tau"}, kernel::Term(1)))};
    return outcome;
  };
  forged.printed.clear();
  CHECK_THROWS_AS(record(forged), InternalError);
}

TEST_CASE("what is so is not refuted") {
  Claim claim{.id = "claim",
              .place = "test",
              .printed = {equation(Term(1), Term(1))},
              .prove = by_counterexample({.point = {{"tau", 1}}, .false_there = {equation(tau, 2)}})};
  CHECK_THROWS_AS(record(claim), InternalError);
  // The counterexample leaves out what is assumed.
  claim.printed = {equation(tau, 2)};
  claim.assumptions = {{"a", equation(tau, 2)}};
  CHECK_THROWS_AS(record(claim), InternalError);
  claim.assumptions = {};
  CHECK(record(claim).outcome.verdict.truth == Truth::refuted);
}

TEST_CASE("what nothing obeys proves nothing") {
  const Statement absurd = equation(tau, tau + 1);
  const Term cosine = cos(z10);
  const auto both = [&](const Statement& a, const Statement& b) { return assuming_all({a, b}, absurd); };
  CHECK(is_not_proved(both(equation(z10 * z20, 1), equation(z10 * z20, 2))));
  CHECK(is_not_proved(both(equation(cosine, 0), {cosine, 0, Relation::not_equal})));
  CHECK(is_not_proved(both({omega1, omega2, Relation::greater}, equation(tau, tau))));
  CHECK(is_not_proved(both(equation(eta, 0), equation(tau, tau))));
  // What follows from them is vacuous, too, however it is written.
  for (const std::vector<Statement>& contradiction :
       {std::vector<Statement>{equation(z10 * z20, 1), equation(z10 * z20, 2)},
        {equation(cosine, 0), {cosine, 0, Relation::not_equal}},
        {{omega1, omega2, Relation::greater}},
        {equation(eta, 0)},
        {{chi, 1, Relation::greater}},
        {{us, 0, Relation::less}}}) {
    CAPTURE(text(contradiction[0]));
    CHECK(is_not_proved(assuming_all(contradiction, equation(tau, tau))));
  }
  CHECK(is_not_proved(both(equation(tau, T), equation(T, tau))));
  CHECK(is_not_proved(both(equation(tau, T + 1), equation(T, tau))));
  CHECK(is_not_proved(assuming_all({equation(tau, tau + 1)}, equation(omega, omega))));
  CHECK(is_not_proved(assuming_all({equation(power(tau, 2), 0)}, equation(tau / tau, Term(1)))));
  CHECK(is_not_proved(assuming_all({equation(power(z10, 2), 0)}, equation(z10 / z10, Term(1)))));
  // What can be obeyed is said to be.
  CHECK(record(assuming_all({equation(tau, pi() / omega)}, equation(omega * tau, pi()))).outcome.obeyed ==
        Obeyed::theorem);
  CHECK(record(assuming_all({}, equation(tau, tau))).outcome.obeyed == Obeyed::none_needed);
}

}  // namespace stickslip::proofs::methods
