// Printed equations as theorems of the kernel: what must be provable, under what, and what must not.
#include "proofs/methods/reading.hpp"

#include <doctest/doctest.h>

#include <sstream>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

Outcome proved(const Statement& statement, const std::vector<Assumption>& assumptions = {}) {
  Prover prover(pascal2012::paper().claims);
  const Claim claim{.id = "test", .printed = {statement}, .assumptions = assumptions};
  return derived("", prover, claim, [](Derivation& derivation, std::size_t which) {
    return derivation.combination(derivation.read(derivation.claim().printed[which]));
  });
}

bool refuses(const Statement& statement, const std::vector<Assumption>& assumptions = {}) {
  const Outcome outcome = proved(statement, assumptions);
  CHECK(outcome.by_kernel == (outcome.verdict.truth == Truth::proved));
  return outcome.verdict.truth == Truth::undecided && outcome.theorems.empty();
}

std::set<std::string> nonzero(const Outcome& outcome) {
  std::set<std::string> result;
  for (const Hypothesis& one : outcome.hypotheses) {
    result.insert(one.text);
  }
  return result;
}

const Assumption half{"26.half", equation(tau, pi() / omega)};

}  // namespace

TEST_CASE("(40) is a theorem under the parameters' domain alone, in this sign only") {
  const Outcome identity = proved(equation(power(H1(t), 2) - I2, H2(t) * H3(t)));
  kernel::Formulas domain;
  for (const kernel::Theorem& one : parameters()) {
    domain.insert(one.hypotheses().begin(), one.hypotheses().end());
  }
  for (const kernel::Formula& hypothesis : identity.theorems.at(0).hypotheses()) {
    CHECK(domain.contains(hypothesis));
  }
  CHECK(identity.hypotheses.empty());
  CHECK(identity.assumed.empty());
  CHECK(refuses(equation(power(H1(t), 2) - I2, -H2(t) * H3(t))));
  CHECK(refuses(equation(power(H1(t), 2) + I2, H2(t) * H3(t))));
  CHECK(refuses(equation(power(H1(t), 2) - I2, H2(t) * H3(s))));
}

TEST_CASE("what is divided by as written is a hypothesis, also where it cancels") {
  const Term factor = (power(omega, 2) - power(omega1, 2)) * (power(omega, 2) - power(omega2, 2));
  const Outcome p_of_q2 = proved(equation(p, factor / (omega * (1 - power(omega, 2))) * q2 * omega));
  CHECK(nonzero(p_of_q2).contains("1 - omega != 0"));
  CHECK(nonzero(proved(equation(tau / tau, 1))) == std::set<std::string>{"tau != 0"});
  CHECK(nonzero(proved(equation(tan(tau) * cos(tau), sin(tau)))) == std::set<std::string>{"cos(tau) != 0"});
  CHECK(nonzero(proved(equation(inverse(H2(tau)) * H2(tau), I2))).size() == 2);
}

TEST_CASE("false equations have no theorem") {
  CHECK(refuses(equation(2, 0)));
  CHECK(refuses(equation(us, 0)));
  CHECK(refuses(equation(Term(Rational("4294967297")) * tau, tau)));
  CHECK(refuses(equation(z10, 0)));
  CHECK(refuses(equation(H(t) * Z0, Gamma(t) * Z0)));
  CHECK(refuses(equation(sin(tau), 0)));
}

TEST_CASE("a value that is given is a hypothesis, where it is needed") {
  const Statement antiperiodic = equation(FB, -F0);
  CHECK(refuses(antiperiodic));
  const Outcome identity = proved(antiperiodic, {half, {"12.V", equation(zdot20, V)}});
  CHECK(identity.assumed == std::set<std::string>{"26.half"});
  CHECK(identity.theorems.at(0).hypotheses().contains(
      kernel::equal(kernel::Variable{"tau"}, kernel::pi() / kernel::Term(kernel::Variable{"omega"}))));
  CHECK(refuses(antiperiodic, {{"whole", equation(tau, 2 * pi() / omega)}}));
  // Not needed, so not among the hypotheses.
  CHECK(proved(equation(power(H1(tau), 2) - I2, H2(tau) * H3(tau)), {half}).assumed.empty());
  // Of what has a formula, too.
  CHECK(proved(equation(2 * chi, 1), {{"chi", equation(chi, Term(Rational(1, 2)))}}).assumed ==
        std::set<std::string>{"chi"});
  // In a circle.
  CHECK(refuses(equation(tau, tau1), {{"a", equation(tau, tau1 + 1)}, {"b", equation(tau1, tau + 1)}}));
}

TEST_CASE("a division by what is zero proves nothing") {
  const Term circle = power(cos(tau), 2) + power(sin(tau), 2) - 1, gap = tau - pi() / omega;
  CHECK(refuses(equation(circle / circle, 1)));
  CHECK(refuses(equation(gap / gap, 1), {half}));  // zero with the given value only
  Prover prover(pascal2012::paper().claims);
  Claim claim{.id = "test", .printed = {equation(circle / circle, 1)}, .prove = by_normal_form()};
  CHECK(claim.prove(prover, claim).verdict.truth == Truth::undecided);
  claim.printed = {equation(gap / gap, 1)};
  claim.assumptions = {half};
  CHECK(claim.prove(prover, claim).verdict.truth == Truth::undecided);
}

TEST_CASE("a derivative is one of a function of time, at all times") {
  const Outcome first = proved(equation(derivative(H2(t)), H1(t)));
  CHECK(first.theorems.at(0).conclusion().kind() == kernel::Kind::exists);
  CHECK(refuses(equation(derivative(H2(t)), -H1(t))));
  CHECK_FALSE(refuses(equation(B3(t), derivative(derivative(B2(t))))));
  CHECK(refuses(equation(B3(t), derivative(B2(t)))));
  // Of a derivative at one instant, which would be a constant.
  CHECK(refuses(equation(derivative(derivative(B2(t))), zero(2, 2))));
  CHECK(refuses(equation(derivative(tau * t), t)));
}

TEST_CASE("what the model gives no meaning has no reading") {
  Reader read;
  CHECK_THROWS_AS(static_cast<void>(read(Function{"Rtilde", {1, 1}}(t))), NoValue);
  CHECK_THROWS_AS(static_cast<void>(read(abs(t))), NoValue);
  // What |t| is at one time says nothing of its derivative there.
  CHECK_NOTHROW(static_cast<void>(read(equation(abs(t), t))));
  CHECK_THROWS_AS(static_cast<void>(read(equation(derivative(abs(t)), 1))), NoValue);
  CHECK_THROWS_AS(static_cast<void>(read(equation(derivative(abs(t)) + abs(t), 1 + abs(t)))), NoValue);
  CHECK(refuses({tau, 0, Relation::greater}));
  CHECK(refuses(equation(Z(t), H(t) * Z0)));
}

TEST_CASE("a motion is a function, and a statement on it one of times") {
  Reader read;
  const kernel::Variable X_of{"X", kernel::function_of_time(4, 1)};
  CHECK(read(X(t)) == kernel::apply(X_of, kernel::Variable{"t"}));
  CHECK(read(Z(tau)).variables().contains(X_of));
  const kernel::Formula slope = read(during(0, tau, {block(1, {0, 0, 0, 1}) * X(t), V, Relation::less}));
  CHECK(slope.kind() == kernel::Kind::for_all);
  CHECK_FALSE(slope.variables().contains({"t"}));  // it is bound
  CHECK(refuses(equation(Z(tau), ZB)));
  CHECK(proved(equation(Z(tau), ZB), {{"B", equation(Z(tau), ZB)}}).verdict.truth == Truth::undecided);
  CHECK(read({abs(z10), us, Relation::less}).kind() == kernel::Kind::conjunction);
}
