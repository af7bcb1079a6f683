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
  CHECK_NOTHROW(static_cast<void>(value_is(exp(-power(T, 2)), -2 * T * exp(-power(T, 2)))));
  REFUSES(value_is(exp(2 * T), exp(2 * T)));
  REFUSES(value_is(exp(T), T * exp(T)));
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
  CHECK(Theorem::continuity(lambda(t, exp(-Term(t))), a, b).hypotheses().empty());
  CHECK(Theorem::continuity(lambda(t, exp(1 / Term(t))), a, b).hypotheses() ==
        Formulas{for_all(t, implies(within(a, t, b), differ(t, 0)))});
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

TEST_CASE("a function by pieces: one value where they meet") {
  const Theorem both = Theorem::piecewise(f, g, c);
  const Variable X{"X", function_of_time()};
  CHECK(both.hypotheses().empty());
  CHECK(both.conclusion() ==
        exists(X, for_all(t, all({implies(less(t, c), equal(apply(X, t), apply(f, t))),
                                  implies(at_most(c, t), equal(apply(X, t), apply(g, t)))}))));
  // Both at c would give f(c) = g(c), and 0 = 1.
  const Theorem there = Theorem::specialize(assume(opened(both.conclusion(), X)), c);
  CHECK_NOTHROW(static_cast<void>(Theorem::consequence(
      {there, Theorem::trichotomy(c, c), Theorem::reflexive(c)}, equal(apply(X, c), apply(g, c)))));
  REFUSES(Theorem::consequence({there, Theorem::trichotomy(c, c), Theorem::reflexive(c)},
                               equal(apply(X, c), apply(f, c))));
  // The new function is none that a piece speaks of: X(t) = X(t) + 1 for no X.
  for (const char * name : {"X", "v1", "f", "t1"}) {
    const Variable own{name, function_of_time()};
    const Term next = lambda(t, apply(own, t) + 1);
    CHECK(Theorem::piecewise(next, next, c).conclusion().variables() == Variables{own, c});
  }
  REFUSES(Theorem::piecewise(f, Variable{"F2", function_of_time(2)}, c));
  REFUSES(Theorem::piecewise(f, g, f));
  REFUSES(Theorem::piecewise(x, y, c));
  REFUSES(Theorem::piecewise(f, g, for_all(t, equal(-Term(t), x)).parts()[0].parts()[0]));
}

TEST_CASE("a function continued: half an interval, of a positive length") {
  const Variable X{"X", function_of_time()};
  CHECK(Theorem::periodic(f, assume(less(0, c))).conclusion() ==
        exists(X, all({for_all(t, implies(all({at_most(0, t), less(t, c)}), equal(apply(X, t), apply(f, t)))),
                       for_all(t, equal(apply(X, Term(t) + c), apply(X, t)))})));
  CHECK(Theorem::periodic(f, assume(less(0, c))).hypotheses() == Formulas{less(0, c)});
  // With c < 0 every function would be constant between, as X(t - |c|) = X(t), and with c = 0 nothing is
  // said.
  REFUSES(Theorem::periodic(f, assume(at_most(0, c))));
  REFUSES(Theorem::periodic(f, assume(less(c, 0))));
  REFUSES(Theorem::periodic(f, assume(less(-1, c))));
  REFUSES(Theorem::periodic(f, assume(differ(c, 0))));
  REFUSES(Theorem::periodic(x, assume(less(0, c))));
  const Term next = lambda(t, apply(X, t) + 1);
  CHECK(Theorem::periodic(next, assume(less(0, c))).conclusion().variables() == Variables{X, c});
}

TEST_CASE("functions that agree on a closed interval are continuous together") {
  const Theorem known = assume(continuous(f, a, b));
  const auto agree = [&](const Formula& where, const Term& one, const Term& other) {
    return assume(for_all(t, implies(where, equal(one, other))));
  };
  const Term at_f = apply(f, t), at_g = apply(g, t);
  CHECK(Theorem::same_continuity(known, agree(within(a, t, b), at_f, at_g)).conclusion() ==
        continuous(g, a, b));
  // A function that jumps at an end agrees with a continuous one inside.
  REFUSES(Theorem::same_continuity(known, agree(between(a, t, b), at_f, at_g)));
  REFUSES(Theorem::same_continuity(known, agree(within(a, t, c), at_f, at_g)));
  REFUSES(Theorem::same_continuity(known, agree(within(a, t, b), at_g, at_f)));
  REFUSES(Theorem::same_continuity(known, assume(equal(apply(f, a), apply(g, a)))));
  REFUSES(Theorem::same_continuity(agree(within(a, t, b), at_f, at_g), known));
  CHECK(Theorem::continuous_union(known, assume(continuous(f, b, c))).conclusion() == continuous(f, a, c));
  // Two functions, a gap, the wrong order.
  REFUSES(Theorem::continuous_union(known, assume(continuous(g, b, c))));
  REFUSES(Theorem::continuous_union(known, assume(continuous(f, x, c))));
  REFUSES(Theorem::continuous_union(assume(continuous(f, b, c)), known));
  REFUSES(Theorem::continuous_union(known, assume(less(b, c))));
}

TEST_CASE("one time is finitely many, whatever it is called") {
  CHECK(Theorem::finite_point(x).conclusion() == finite(t, equal(t, x)));
  CHECK(Theorem::finite_point(t).conclusion() == finite(s, equal(s, t)));
  CHECK(Theorem::finite_point(t).conclusion() != finite(t, equal(t, t)));
  REFUSES(Theorem::finite_point(f));
  REFUSES(Theorem::finite_point(v));
  REFUSES(Theorem::finite_point(for_all(t, equal(-Term(t), x)).parts()[0].parts()[0]));
}
