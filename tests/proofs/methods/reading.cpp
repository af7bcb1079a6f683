// Printed equations as theorems of the kernel: what must be provable, under what, and what must not.
#include "proofs/methods/reading.hpp"

#include <doctest/doctest.h>

#include <sstream>

#include "proofs/methods/claim.hpp"
#include "proofs/methods/deciding.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/vocabulary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

const std::set<std::string> everything{"39", "6.d0", "7", "35.def", "70.rho"};

Identity proved(const Statement& statement, const std::vector<Assumption>& assumptions = {}) {
  return prove_identity(statement, assumptions, everything);
}

bool refuses(const Statement& statement, const std::vector<Assumption>& assumptions = {}) {
  try {
    static_cast<void>(prove_identity(statement, assumptions, everything));
    return false;
  } catch (const kernel::KernelError&) {
    return true;
  } catch (const NoValue&) {
    return true;
  }
}

std::set<std::string> nonzero(const Identity& identity) {
  std::set<std::string> result;
  for (const GiNaC::ex& factor : identity.nonzero) {
    result.insert((std::ostringstream() << factor).str());
  }
  return result;
}

const Assumption half{"26.half", equation(tau, pi() / omega)};

}  // namespace

TEST_CASE("(40) is a theorem under the parameters' domain alone, in this sign only") {
  const Identity identity = proved(equation(power(H1(t), 2) - I2, H2(t) * H3(t)));
  kernel::Formulas domain;
  for (const kernel::Theorem& one : parameters()) {
    domain.insert(one.hypotheses().begin(), one.hypotheses().end());
  }
  for (const kernel::Formula& hypothesis : identity.theorem.hypotheses()) {
    CHECK(domain.contains(hypothesis));
  }
  CHECK(identity.nonzero.empty());
  CHECK(identity.assumed.empty());
  CHECK(refuses(equation(power(H1(t), 2) - I2, -H2(t) * H3(t))));
  CHECK(refuses(equation(power(H1(t), 2) + I2, H2(t) * H3(t))));
  CHECK(refuses(equation(power(H1(t), 2) - I2, H2(t) * H3(s))));
}

TEST_CASE("what is divided by as written is a hypothesis, also where it cancels") {
  const Term factor = (power(omega, 2) - power(omega1, 2)) * (power(omega, 2) - power(omega2, 2));
  const Identity p_of_q2 = proved(equation(p, factor / (omega * (1 - power(omega, 2))) * q2 * omega));
  CHECK(nonzero(p_of_q2).contains("1-omega"));
  CHECK(nonzero(proved(equation(tau / tau, 1))) == std::set<std::string>{"tau"});
  CHECK(nonzero(proved(equation(tan(tau) * cos(tau), sin(tau)))) == std::set<std::string>{"cos(tau)"});
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
  const Identity identity = proved(antiperiodic, {half, {"12.V", equation(zdot20, V)}});
  CHECK(identity.assumed == std::set<std::string>{"26.half"});
  CHECK(identity.theorem.hypotheses().contains(
      kernel::equal(kernel::Variable{"tau"}, kernel::pi() / kernel::Term(kernel::Variable{"omega"}))));
  CHECK(refuses(antiperiodic, {{"whole", equation(tau, 2 * pi() / omega)}}));
  // Not needed, so not among the hypotheses.
  CHECK(proved(equation(power(H1(tau), 2) - I2, H2(tau) * H3(tau)), {half}).assumed.empty());
  // A value of what has a formula says something about what is in it: it is not put in.
  CHECK(refuses(equation(2 * chi, 1), {{"chi", equation(chi, Term(Rational(1, 2)))}}));
  // In a circle.
  CHECK(refuses(equation(tau, tau1), {{"a", equation(tau, tau1 + 1)}, {"b", equation(tau1, tau + 1)}}));
}

TEST_CASE("a division by what is zero where the claim's assumptions hold proves nothing") {
  Claim claim;
  claim.id = "vacuous";
  claim.assumptions = {half};
  const Term circle = power(cos(tau), 2) + power(sin(tau), 2) - 1;
  Outcome outcome;
  decide(outcome, claim, equation(circle / circle, 1));
  CHECK(outcome.theorems.empty());
  CHECK_FALSE(outcome.by_kernel);
  // Zero with the given value only.
  const Term gap = tau - pi() / omega;
  CHECK_THROWS_AS(decide(outcome, claim, equation(gap / gap, 1)), GiNaC::pole_error);
}

TEST_CASE("a derivative is one of a function of time, at all times") {
  const Identity first = proved(equation(derivative(H2(t)), H1(t)));
  CHECK(first.theorem.conclusion().kind() == kernel::Kind::exists);
  CHECK(refuses(equation(derivative(H2(t)), -H1(t))));
  CHECK_FALSE(refuses(equation(B3(t), derivative(derivative(B2(t))))));
  CHECK(refuses(equation(B3(t), derivative(B2(t)))));
  // Of a derivative at one instant, which would be a constant.
  CHECK(refuses(equation(derivative(derivative(B2(t))), zero(2, 2))));
  CHECK(refuses(equation(derivative(tau * t), t)));
}

TEST_CASE("what the model gives no meaning has no reading") {
  Reader read;
  CHECK_THROWS_AS(static_cast<void>(read(Z(t))), NoValue);
  CHECK_THROWS_AS(static_cast<void>(read(abs(t))), NoValue);
  CHECK(refuses({tau, 0, Relation::greater}));
  CHECK(refuses(equation(Z(t), H(t) * Z0)));
}
