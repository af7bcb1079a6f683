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

TEST_CASE("what fails for a motion from any state is refuted, where no motion is known to exist, it is not") {
  const Statement false_at_most_points = equation(z10, 0);
  const Statement law = equation(derivative(X(t)), first_order(K) * X(t) + column({0, 0, 0, eta * us}));
  const Assumption phase{"phase", during(0, tau, law)}, begins{"begins", equation(Z(0), Z0)};
  const auto status = [&](const std::vector<Assumption>& assumptions) {
    return record(claim(false_at_most_points, assumptions)).status;
  };
  CHECK(status({phase, begins}) == Status::refuted);
  // Z(0) = Z_0 = E Z_0 has z_1(0) = 0.
  CHECK(status({phase, begins, {"too", equation(Z(0), E * Z0)}}) == Status::undecided);
  CHECK(status({phase, begins, {"too", equation(Z(tau), E * Z0)}}) == Status::undecided);
  // A motion may be joined of two, one after the other; not of two laws at the same time.
  CHECK(status({phase, begins, {"second", during(tau, Theta, law)}}) == Status::refuted);
  const Statement other = equation(derivative(X(t)), first_order(K) * X(t));
  CHECK(status({phase, begins, {"second", during(0, Theta, other)}}) == Status::undecided);
  // A law with a sign may hold for no motion at all.
  const Statement coulomb = equation(
      derivative(X(t)), first_order(K) * X(t) + column({0, 0, 0, eta * us * sign(component(3, X(t)))}));
  CHECK(status({{"law", almost_always(0, tau, coulomb)}, begins}) == Status::undecided);
  CHECK(status({{"law", almost_always(0, tau, law)}, begins}) == Status::undecided);
  // So may one that is not linear, or whose force is not finite at all times.
  const Term state = X(t), speed = component(3, state);
  CHECK(status({{"law", during(0, tau, equation(derivative(state), column({0, 0, 0, speed * speed})))},
                begins}) == Status::undecided);
  CHECK(status({{"law", during(0, tau, equation(derivative(state), column({0, 0, 0, tan(t)})))}, begins}) ==
        Status::undecided);
  CHECK(status({{"law", during(0, tau, equation(derivative(state), first_order(K) * X(t + 1)))}, begins}) ==
        Status::undecided);
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
