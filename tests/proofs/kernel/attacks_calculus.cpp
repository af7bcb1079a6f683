// Attacks on calculus: each would let a false sequent through if it were not refused.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

TEST_CASE("growth") {
  const Variable w{"w"}, F2{"F2", function_of_time(2)};
  const auto few = [&](const Formula& good) {
    return assume(finite(t, all({between(a, t, b), negation(exists(w, good))})));
  };
  const Formula grows = all({derivative(f, t, w), at_most(0, w)});
  const Theorem smooth = assume(continuous(f, a, b));
  CHECK(Theorem::monotone(smooth, few(grows)).conclusion() ==
        implies(at_most(a, b), at_most(apply(f, a), apply(f, b))));
  REFUSES(Theorem::monotone(smooth, few(all({derivative(g, t, w), at_most(0, w)}))));
  REFUSES(Theorem::monotone(smooth, few(all({derivative(f, s, w), at_most(0, w)}))));
  REFUSES(Theorem::monotone(smooth, few(all({derivative(f, t, w), at_most(w, 0)}))));
  REFUSES(Theorem::monotone(smooth, few(at_most(0, w))));
  REFUSES(Theorem::monotone(assume(continuous(f, a, c)), few(grows)));
  REFUSES(Theorem::monotone(few(grows), few(grows)));
  REFUSES(Theorem::monotone(assume(continuous(F2, a, b)), few(grows)));
}

TEST_CASE("differentiation") {
  const auto slope = [](const Term& body, const Term& point) {
    return Theorem::differentiate(lambda(t, body), point);
  };
  const auto value_is = [&](const Term& body, const Term& value) {
    const Term computed = slope(body, t).conclusion().parts()[2];
    return Theorem::combination(equal(computed, value));
  };
  const Term T = t;
  CHECK_NOTHROW(static_cast<void>(value_is(power(T, 3), 3 * power(T, 2))));
  CHECK_NOTHROW(static_cast<void>(value_is(sin(2 * T), 2 * cos(2 * T))));
  CHECK_NOTHROW(static_cast<void>(value_is(1 / T, -1 / power(T, 2))));
  REFUSES(value_is(sin(2 * T), cos(2 * T)));
  REFUSES(value_is(power(T, 2), T));
  REFUSES(value_is(cos(T), sin(T)));
  REFUSES(value_is(T * T, 1));
  REFUSES(value_is(power(T, 0), 1));
  // The derivative of tan at a pole, of 1/t at 0: the divisor at the point.
  CHECK(slope(1 / T, x).hypotheses() == Formulas{differ(x, 0)});
  REFUSES(Theorem::combination(equal(slope(1 / T, 0).conclusion().parts()[2], 0)));
  CHECK(slope(1 / T, 0).hypotheses() == Formulas{differ(0, 0)});
  CHECK(slope(T / T, 0).hypotheses() == Formulas{differ(0, 0)});
  CHECK(slope(tan(T), x).hypotheses() == Formulas{differ(cos(x), 0)});
  // A definition that depends on the time is looked into, divisors and all.
  const Definition reciprocal("reciprocal", {x}, 1 / Term(x));
  CHECK(slope(reciprocal({T - 1}), 1).hypotheses() == Formulas{differ(Term(1) + -Term(1), 0)});
  CHECK(slope(reciprocal({T}), x).hypotheses() == Formulas{differ(x, 0)});
  // A matrix: the divisor is the determinant.
  const Theorem turning = slope(inverse(matrix(2, 2, {T, 0, 0, T})), 0);
  CHECK(turning.hypotheses().size() == 1);
  // Of a function variable only by a premise, at its point.
  REFUSES(slope(apply(f, T), x));
  REFUSES(Theorem::differentiate(f, x, {assume(derivative(f, y, 0))}));
  REFUSES(Theorem::differentiate(f, x, {assume(derivative(g, x, 0))}));
  REFUSES(Theorem::differentiate(f, x, {assume(continuous(f, x, x))}));
  REFUSES(Theorem::differentiate(x, 0));
  REFUSES(Theorem::differentiate(lambda(t, apply(f, T)), v));
  // f(f(t)): the outer one at the inner value.
  const Term twice = lambda(t, apply(f, apply(f, T)));
  REFUSES(Theorem::differentiate(twice, 0, {assume(derivative(f, 0, a))}));
  const Theorem chain =
      Theorem::differentiate(twice, 0, {assume(derivative(f, 0, a)), assume(derivative(f, apply(f, 0), b))});
  CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(chain.conclusion().parts()[2], Term(b) * a))));
  // The value of the premise may hold the point's name, not the time's.
  const Theorem named =
      Theorem::differentiate(lambda(s, apply(f, s) * Term(s)), t, {assume(derivative(f, t, T))});
  CHECK_NOTHROW(
      static_cast<void>(Theorem::combination(equal(named.conclusion().parts()[2], T * T + apply(f, T)))));
  // Two derivatives are one only for one function at one point.
  REFUSES(Theorem::unique_derivative(assume(derivative(f, t, a)), assume(derivative(f, s, b))));
  REFUSES(Theorem::unique_derivative(assume(derivative(f, t, a)), assume(derivative(g, t, b))));
  REFUSES(Theorem::unique_derivative(assume(derivative(f, t, a)), assume(equal(a, b))));
}

TEST_CASE("functions that agree have one derivative, on an open interval only") {
  const Theorem known = assume(derivative(f, x, c)), lower = assume(less(a, x)), upper = assume(less(x, b));
  const Formula agree = for_all(t, implies(between(a, t, b), equal(apply(f, t), apply(g, t))));
  CHECK(Theorem::same_derivative(known, assume(agree), lower, upper).conclusion() == derivative(g, x, c));
  // |t| and t agree on [0, 1], and at 0: no derivative there.
  REFUSES(Theorem::same_derivative(known, assume(agree), assume(at_most(a, x)), upper));
  REFUSES(Theorem::same_derivative(known, assume(agree), lower, assume(at_most(x, b))));
  REFUSES(Theorem::same_derivative(
      known, assume(for_all(t, implies(within(a, t, b), equal(apply(f, t), apply(g, t))))), lower, upper));
  REFUSES(Theorem::same_derivative(known, assume(equal(apply(f, x), apply(g, x))), lower, upper));
  REFUSES(Theorem::same_derivative(known, assume(agree), lower, assume(less(y, b))));
}

TEST_CASE("continuity") {
  CHECK(Theorem::continuity(lambda(t, 1 / Term(t)), -1, 1).hypotheses() ==
        Formulas{for_all(t, implies(within(-1, t, 1), differ(t, 0)))});
  CHECK(Theorem::continuity(lambda(t, tan(t)), a, b).hypotheses() ==
        Formulas{for_all(t, implies(within(a, t, b), differ(cos(t), 0)))});
  REFUSES(Theorem::continuity(f, a, b));
  REFUSES(Theorem::continuity(f, a, b, {assume(continuous(g, a, b))}));
  REFUSES(Theorem::continuity(f, a, b, {assume(continuous(f, a, c))}));
  REFUSES(Theorem::continuity(f, a, b, {assume(continuous(f, b, a))}));
  REFUSES(Theorem::continuity(lambda(t, apply(f, -Term(t))), a, b, {assume(continuous(f, a, b))}));
  const Term turned = lambda(t, apply(f, -Term(t)));
  const Formula range = for_all(t, implies(within(a, t, b), within(-Term(b), -Term(t), -Term(a))));
  CHECK_NOTHROW(static_cast<void>(
      Theorem::continuity(turned, a, b, {assume(continuous(f, -Term(b), -Term(a))), assume(range)})));
  REFUSES(Theorem::continuity(turned, a, b, {assume(continuous(f, -Term(a), -Term(b))), assume(range)}));
  const Theorem whole = assume(continuous(f, a, b));
  REFUSES(Theorem::continuous_within(whole, assume(at_most(c, a)), assume(at_most(x, b))));
  REFUSES(Theorem::continuous_within(whole, assume(at_most(a, c)), assume(at_most(b, x))));
  REFUSES(Theorem::continuous_within(whole, assume(at_most(a, c)), assume(differ(x, b))));
}

TEST_CASE("finite sets moved") {
  const Theorem few = assume(finite(t, equal(apply(f, t), x)));
  CHECK(Theorem::finite_shift(few, c).conclusion() == finite(t, equal(apply(f, Term(t) + c), x)));
  CHECK(Theorem::finite_shift(few, c).hypotheses() == few.hypotheses());
  // By a number named like the one that is counted: not finite t: 0 = 0, whose set is the whole line.
  const Theorem origin = assume(finite(t, equal(t, 0)));
  const Formula moved = Theorem::finite_shift(origin, -Term(t)).conclusion();
  CHECK(moved == finite(s, equal(Term(s) + -Term(t), 0)));
  CHECK(moved != finite(t, equal(Term(t) + -Term(t), 0)));
  CHECK(moved.variables() == Variables{t});
  // What is no finite set, and what is no number.
  REFUSES(Theorem::finite_shift(assume(for_all(t, equal(apply(f, t), x))), c));
  REFUSES(Theorem::finite_shift(assume(exists(t, equal(apply(f, t), x))), c));
  REFUSES(Theorem::finite_shift(assume(equal(x, 0)), c));
  REFUSES(Theorem::finite_shift(few, f));
  REFUSES(Theorem::finite_shift(few, v));
  REFUSES(Theorem::finite_shift(few, equal(x, 0)));
  REFUSES(Theorem::finite_shift(assume(continuous(f, a, b)), c));
  // By a part of a binder's body, cut out: its index would be caught by the set's.
  REFUSES(Theorem::finite_shift(origin, for_all(t, equal(-Term(t), x)).parts()[0].parts()[0]));
}
