#include "proofs/methods/refutation.hpp"

#include <doctest/doctest.h>

#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/closed.hpp"
#include "tests/proofs/checks/decided.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;
using kernel::KernelError;
using kernel::Theorem;

namespace {

// "All of these, and none of those" has the values at the point.
Theorem refuted(const std::vector<Statement>& holding, const std::vector<Statement>& failing,
                const Scene& scene = {{{"omega1", Rational(1, 2)}, {"omega2", 2}, {"tau", 1}}}) {
  Prover nothing_else({});
  return refutation(nothing_else, scene, holding, failing);
}

const Statement true_there{tau, 0, Relation::greater}, false_there = equation(cos(omega1 * tau), 1);
const Statement law = equation(
    derivative(X(t)), first_order(K) * X(t) + column({0, 0, 0, eta * us + p * cos(omega * t + phi)}));

}  // namespace

TEST_CASE("a refutation is the sequent's negation, and has no hypotheses") {
  const Theorem theorem = refuted({true_there}, {false_there});
  CHECK(theorem.hypotheses().empty());
  kernel::Formula inside = theorem.conclusion();
  while (inside.kind() == kernel::Kind::exists) {
    inside = opened(inside, kernel::Variable{inside.name(), inside.binds()});
  }
  Reader read;
  const kernel::Variable first{"omega1"};
  CHECK(inside == kernel::all({read(true_there), kernel::negation(read(false_there)), kernel::less(0, first),
                               kernel::less(first, 1)}));
}

TEST_CASE("nothing is refuted where something assumed fails, or what is concluded holds") {
  CHECK_THROWS_AS(refuted({{tau, 0, Relation::less}}, {false_there}), KernelError);
  CHECK_THROWS_AS(refuted({true_there, equation(tau, 2)}, {false_there}), KernelError);
  CHECK_THROWS_AS(refuted({true_there}, {equation(power(cos(tau), 2) + power(sin(tau), 2), 1)}), KernelError);
  CHECK_THROWS_AS(refuted({true_there}, {{tau, 0, Relation::greater_or_equal}}), KernelError);
  // All that fails has to fail.
  CHECK_THROWS_AS(refuted({}, {false_there, true_there}), KernelError);
  // Neither side of what divides by zero is known: 1/0 may be 1.
  CHECK_THROWS_AS(refuted({}, {equation(1 / (tau - 1), 1)}), KernelError);
  CHECK_THROWS_AS(refuted({{1 / (tau - 1), 0, Relation::greater_or_equal}}, {false_there}), KernelError);
}

TEST_CASE("nothing is refuted outside the domain, or by values that contradict each other") {
  CHECK_THROWS_AS(refuted({}, {false_there}, {{{"omega1", 2}, {"omega2", 3}, {"tau", 1}}}), KernelError);
  const Statement negative = equation(tau, omega);
  CHECK_THROWS_AS(
      refuted({negative}, {false_there}, {{{"omega1", Rational(1, 2)}, {"omega", -1}}, {negative}}),
      KernelError);
  const Statement here = equation(tau, pi() / omega), there = equation(tau, 1);
  CHECK_NOTHROW(refuted({here}, {false_there}, {{{"omega1", Rational(1, 2)}, {"omega", 1}}, {here}}));
  CHECK_THROWS_AS(
      refuted({here, there}, {false_there}, {{{"omega1", Rational(1, 2)}, {"omega", 1}}, {here, there}}),
      KernelError);
  // In a circle.
  CHECK_THROWS_AS(refuted({}, {equation(tau, 0)}, {{}, {equation(tau, T), equation(T, tau)}}), KernelError);
  // What the model has a formula for takes no other value.
  CHECK_THROWS_AS(refuted({equation(chi, 3)}, {false_there}, {{{"tau", 1}}, {equation(chi, 3)}}),
                  KernelError);
}

TEST_CASE("a motion that refutes is one that the theorem has") {
  const Statement phase = during(0, tau, law), starts = equation(Z(0), Z0);
  const Statement stands_still = equation(Z(tau), Z0);
  const Theorem theorem = refuted({phase, starts}, {stands_still});
  CHECK(theorem.hypotheses().empty());
  CHECK_THROWS_AS(refuted({phase, starts, stands_still}, {false_there}), KernelError);
  CHECK_THROWS_AS(refuted({phase, starts}, {equation(Z(0), Z0)}), KernelError);
  // Not with the flow of another phase: x2' does not stay where the mass slips.
  const Statement stick = equation(derivative(X(t)), first_order(stick_matrix) * X(t));
  CHECK_NOTHROW(refuted({during(0, tau, stick), starts}, {stands_still}));
  CHECK_THROWS_AS(refuted({phase, during(tau, Theta, stick), starts}, {stands_still}), KernelError);
  // The whole of (5) stands against it.
  CHECK_THROWS_AS(refuted({phase, starts}, {equation(Z(tau), H(tau) * (Z0 - F0) + F(tau))}), KernelError);
}

TEST_CASE("every formula that the audit calls refuted is one by a theorem") {
  for (const char * id : {"4.defined", "4.unique", "19", "37.enough", "45", "47.c", "67.branch"}) {
    CAPTURE(id);
    const Outcome& outcome = record(id).outcome;
    CHECK(outcome.verdict.truth == Truth::refuted);
    CHECK(outcome.by_kernel);
    REQUIRE(outcome.theorems.size() == 1);
    CHECK(outcome.theorems.front().hypotheses().empty());
  }
  const std::optional<Outcome>& converse = record("16").converse;
  REQUIRE((converse && converse->verdict.truth == Truth::refuted));
  CHECK(converse->theorems.size() == 1);
}

TEST_CASE("formulas without variables are decided as far as balls and normal forms go, and no further") {
  using namespace proofs::tactics;
  using kernel::differ;
  using kernel::less;
  const kernel::Term one = 1, root = kernel::sin(kernel::pi() / kernel::Term(4));
  const kernel::Term zero_over_zero = kernel::inverse(one - one);
  const auto decides = [](const kernel::Formula& formula) {
    const auto made = [&](const auto& rule) {
      try {
        return rule(formula, KnownRoots{}).hypotheses().empty();
      } catch (const KernelError&) {
        return false;
      }
    };
    return std::pair(made(certainly), made(certainly_not));
  };
  const std::pair holds(true, false), fails(false, true), open(false, false);
  CHECK(decides(less(0, root)) == holds);
  CHECK(decides(less(root, 0)) == fails);
  CHECK(decides(kernel::equal(kernel::sin(kernel::pi()), 0)) == holds);
  CHECK(decides(kernel::at_most(kernel::sin(kernel::pi()), 0)) == holds);
  CHECK(decides(less(kernel::sin(kernel::pi()), 0)) == fails);
  CHECK(decides(differ(root, 1)) == holds);
  CHECK(decides(kernel::equal(root, kernel::cos(kernel::pi() / kernel::Term(4)))) == holds);
  CHECK(decides(kernel::at_most(2 * root * root, 1)) == holds);
  CHECK(decides(less(2 * root * root, 1)) == fails);
  CHECK(decides(kernel::all({less(0, root), less(root, 0)})) == fails);
  CHECK(decides(kernel::any({less(0, root), less(root, 0)})) == holds);
  CHECK(decides(kernel::all({})) == holds);
  CHECK(decides(kernel::any({})) == fails);
  const auto pair_of = [](const kernel::Term& a, const kernel::Term& b) {
    return kernel::matrix(2, 1, {a, b});
  };
  CHECK(decides(kernel::equal(pair_of(1, root), pair_of(1, 1))) == fails);
  CHECK(decides(kernel::equal(pair_of(1, root), pair_of(1, root))) == holds);
  CHECK(decides(kernel::equal(zero_over_zero, 1)) == open);
  CHECK(decides(less(zero_over_zero, 1)) == open);
  CHECK(decides(less(kernel::Variable{"x"}, 1)) == open);
  const kernel::Variable x{"x"};
  CHECK(decides(kernel::exists(x, kernel::equal(x, 0))) == open);
}

TEST_CASE("a motion of two phases is joined of two flows that meet, or is one where nothing changes") {
  // Without a load the masses are at rest at delta0, and move from there when the friction turns round.
  const auto slips = [](const Term& friction) {
    return equation(derivative(X(t)),
                    first_order(K) * X(t) + column({0, 0, 0, friction + p * cos(omega * t + phi)}));
  };
  const Statement below = during(0, tau, slips(eta * us)), above = during(tau, Theta, slips(-eta * us)),
                  again = during(tau, Theta, slips(eta * us));
  const Term rest = symbols::zero(4, 1);
  const Scene scene{.point = {{"tau", 1}, {"Theta", 2}, {"p", 0}}, .values = {}, .state = 0};
  const Statement begins = equation(Z(0), rest), there = equation(Z(tau), rest);
  CHECK(refuted({below, again, begins, there}, {}, scene).hypotheses().empty());
  CHECK(refuted({below, above, begins, there}, {}, scene).hypotheses().empty());
  CHECK(refuted({below, above, begins, there}, {equation(Z(Theta), rest)}, scene).hypotheses().empty());
  CHECK_THROWS_AS(refuted({below, above, begins, equation(Z(tau), column({1, 0, 0, 0}))}, {}, scene),
                  KernelError);
  CHECK_THROWS_AS(refuted({below, above, begins, there, equation(Z(Theta), rest)}, {}, scene), KernelError);
}
