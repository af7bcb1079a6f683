// Attacks on rules of logic, and premises of the wrong kind: each would let a false sequent through if it
// were not refused.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

TEST_CASE("logic") {
  const Formula A = equal(x, 0), B = equal(y, 0), C = equal(c, 0);
  SUBCASE("truth tables") {
    REFUSES(Theorem::consequence({}, A));
    REFUSES(Theorem::consequence({}, falsity));
    REFUSES(Theorem::consequence({assume(A)}, B));
    REFUSES(Theorem::consequence({assume(any({A, B}))}, A));
    REFUSES(Theorem::consequence({assume(any({A, B}))}, all({A, B})));
    REFUSES(Theorem::consequence({assume(implies(A, B))}, implies(B, A)));
    REFUSES(Theorem::consequence({assume(implies(A, B)), assume(B)}, A));
    REFUSES(Theorem::consequence({assume(implies(A, B)), assume(negation(A))}, negation(B)));
    REFUSES(Theorem::consequence({assume(negation(all({A, B})))}, negation(A)));
    REFUSES(Theorem::consequence({assume(A)}, x));
    CHECK(Theorem::consequence({}, any({A, negation(A)})).hypotheses().empty());
    CHECK(Theorem::consequence({assume(A), assume(negation(A))}, falsity).hypotheses().size() == 2);
    CHECK(Theorem::consequence({}, all({})).hypotheses().empty());
    // The tables know nothing of what atoms say.
    REFUSES(Theorem::consequence({assume(for_all(x, A))}, A));
    REFUSES(Theorem::consequence({assume(equal(x, y))}, equal(y, x)));
    REFUSES(Theorem::consequence({assume(less(x, y))}, at_most(x, y)));
    REFUSES(Theorem::consequence({assume(for_all(x, any({A, B})))}, any({for_all(x, A), B})));
  }
  SUBCASE("for all: the variable is in no hypothesis") {
    REFUSES(Theorem::generalize(assume(A), x));
    REFUSES(Theorem::generalize(weakened(Theorem::trichotomy(x, 1), {less(x, y)}), x));
    REFUSES(Theorem::generalize(weakened(Theorem::trichotomy(x, 1), {for_all(y, less(x, y))}), x));
    REFUSES(for_every(x, B, assume(A)));
    CHECK_NOTHROW(static_cast<void>(Theorem::generalize(assume(for_all(x, A)), x)));
    // The divisor of a step is a hypothesis too.
    REFUSES(Theorem::generalize(Theorem::combination(equal(Term(x) / x, 1)), x));
    REFUSES(Theorem::generalize(Theorem::sign(less(0, Term(x)), {{x, {1, 2}}}), x));
    // Generalizing another x than the one in the sequent says nothing of the latter.
    const Theorem other = Theorem::generalize(assume(A), Variable{"x", {Sort::real, 2, 1}});
    CHECK(other.conclusion().variables() == Variables{x});
  }
  SUBCASE("for all to one, of its own type") {
    REFUSES(Theorem::specialize(assume(A), 0));
    REFUSES(Theorem::specialize(assume(exists(x, A)), 0));
    REFUSES(Theorem::specialize(assume(for_all(v, equal(v, zero(v.type)))), M));
    REFUSES(Theorem::specialize(assume(for_all(f, equal(apply(f, 0), 0))), x));
  }
  SUBCASE("there is: the witness has the property, and nothing of it leaks") {
    REFUSES(Theorem::witness(assume(A), exists(x, less(x, 0)), 0));
    REFUSES(Theorem::witness(assume(A), for_all(x, A), x));
    REFUSES(Theorem::witness(assume(A), exists(x, A), y));
    const Theorem some = assume(exists(x, A));
    REFUSES(Theorem::choose(some, x, assume(A)));
    REFUSES(Theorem::choose(some, y, assume(B)));
    REFUSES(Theorem::choose(some, y, weakened(assume(C), {B, less(y, 1)})));
    REFUSES(Theorem::choose(assume(exists(x, equal(x, y))), y, assume(C)));
    REFUSES(Theorem::choose(assume(for_all(x, A)), y, assume(C)));
    CHECK(Theorem::choose(some, y, weakened(assume(C), {B})).hypotheses() == Formulas{C, exists(x, A)});
  }
  SUBCASE("discharge and cut take away that one hypothesis and no other") {
    const Theorem theorem = weakened(assume(A), {B});
    CHECK(Theorem::discharge(theorem, C).hypotheses() == Formulas{A, B});
    CHECK(Theorem::discharge(theorem, C).conclusion() == implies(C, A));
    CHECK(Theorem::cut(assume(C), theorem).hypotheses() == Formulas{A, B, C});
    CHECK(Theorem::cut(assume(A), theorem).hypotheses() == Formulas{A, B});
    CHECK(Theorem::cut(Theorem::consequence({}, any({A, negation(A)})), theorem).hypotheses() ==
          Formulas{A, B});
  }
  SUBCASE("equals for equals, where the formula says") {
    const Theorem same = assume(equal(x, y));
    CHECK(Theorem::replace(same, a, less(a, x), assume(less(x, x))).conclusion() == less(y, x));
    REFUSES(Theorem::replace(same, a, less(a, y), assume(less(x, x))));
    REFUSES(Theorem::replace(same, v, equal(v, v), assume(less(x, x))));
    // A bound variable is not the free one of its name.
    const Formula bound = for_all(x, less(x, c));
    CHECK(by_rewriting(assume(bound), same).conclusion() == bound);
    REFUSES(Theorem::replace(same, a, for_all(x, less(a, c)), assume(bound)));
  }
}

TEST_CASE("a premise is of the kind that the rule needs, not only of its parts") {
  const Theorem rate = assume(derivative(f, a, b)), smooth = assume(continuous(f, a, b));
  const Theorem flat = assume(for_all(t, implies(between(a, t, b), derivative(f, t, 0))));
  const Theorem agree = assume(for_all(t, implies(within(a, t, b), equal(apply(f, t), apply(g, t)))));
  const Theorem open_agree = assume(for_all(t, implies(between(c, t, x), equal(apply(f, t), apply(g, t)))));
  const Variable w{"w"};
  const Theorem few = assume(
      finite(t, all({between(a, t, b), negation(exists(w, all({derivative(f, t, w), at_most(0, w)})))})));
  REFUSES(Theorem::constant(rate, flat));
  REFUSES(Theorem::monotone(rate, few));
  REFUSES(Theorem::mean_value(rate, flat, assume(less(a, b))));
  REFUSES(Theorem::continuous_within(rate, assume(at_most(a, c)), assume(at_most(x, b))));
  REFUSES(Theorem::same_derivative(smooth, open_agree, assume(less(c, a)), assume(less(a, x))));
  REFUSES(Theorem::unique_derivative(smooth, assume(continuous(f, a, c))));
  REFUSES(Theorem::unique_derivative(rate, assume(continuous(f, a, c))));
  REFUSES(Theorem::unique_derivative(assume(continuous(f, a, c)), rate));
  REFUSES(Theorem::mean_value(smooth, assume(for_all(t, implies(between(a, t, b), continuous(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::finite_part(assume(for_all(t, less(0, t))),
                               assume(for_all(t, implies(less(1, t), less(0, t))))));
  REFUSES(Theorem::finite_part(assume(exists(t, less(0, t))),
                               assume(for_all(t, implies(less(1, t), less(0, t))))));
  REFUSES(Theorem::finite_part(assume(finite(t, less(0, t))),
                               assume(exists(t, implies(less(1, t), less(0, t))))));
  REFUSES(
      Theorem::finite_part(assume(finite(t, less(0, t))), assume(for_all(t, all({less(1, t), less(0, t)})))));
  REFUSES(Theorem::finite_union(assume(exists(t, less(0, t))), assume(finite(t, less(1, t)))));
  REFUSES(Theorem::finite_union(assume(finite(t, less(1, t))), assume(exists(t, less(0, t)))));
  REFUSES(Theorem::order(less(a, b), {{{assume(equal(a, b))}}}));
  // finite, exists and for all have a body alike.
  const Formula positive = less(0, t);
  REFUSES(Theorem::specialize(assume(finite(t, positive)), 0));
  REFUSES(Theorem::witness(assume(positive), finite(t, positive), t));
  REFUSES(Theorem::choose(assume(finite(t, positive)), x, assume(equal(c, 0))));
  REFUSES(Theorem::mean_value(smooth, assume(exists(t, implies(between(a, t, b), derivative(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::mean_value(smooth, assume(finite(t, implies(between(a, t, b), derivative(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(
      Theorem::finite_part(assume(finite(t, positive)), assume(finite(t, implies(less(1, t), positive)))));
  // An implication is no "and", whatever its parts.
  REFUSES(Theorem::mean_value(smooth, assume(for_all(t, all({between(a, t, b), derivative(f, t, 0)}))),
                              assume(less(a, b))));
  REFUSES(Theorem::mean_value(smooth, assume(for_all(t, implies(between(a, t, b), derivative(f, a, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::mean_value(smooth, assume(for_all(t, implies(within(t, a, b), derivative(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::zeros_between(assume(equal(apply(f, x), 0)), assume(less(Term(0) * pi(), x)),
                                 assume(less(x, Term(1) * pi()))));
}

TEST_CASE("a function is zero between two values of different signs") {
  const Theorem smooth = assume(continuous(f, a, b)), start = assume(less(apply(f, a), 0)),
                end = assume(less(0, apply(f, b))), order = assume(less(a, b));
  const Theorem zero = Theorem::intermediate_value(smooth, start, end, order);
  CHECK(zero.conclusion() == exists(t, all({between(a, t, b), equal(apply(f, t), 0)})));
  CHECK(zero.hypotheses().size() == 4);
  REFUSES(Theorem::intermediate_value(assume(derivative(f, a, b)), start, end, order));
  REFUSES(Theorem::intermediate_value(assume(continuous(g, a, b)), start, end, order));
  REFUSES(Theorem::intermediate_value(assume(continuous(f, a, c)), start, end, order));
  REFUSES(Theorem::intermediate_value(smooth, assume(less(apply(f, b), 0)), end, order));
  REFUSES(Theorem::intermediate_value(smooth, assume(less(0, apply(f, a))), end, order));
  REFUSES(Theorem::intermediate_value(smooth, assume(at_most(apply(f, a), 0)), end, order));
  REFUSES(Theorem::intermediate_value(smooth, assume(less(apply(f, a), 1)), end, order));
  REFUSES(Theorem::intermediate_value(smooth, start, assume(less(0, apply(f, a))), order));
  REFUSES(Theorem::intermediate_value(smooth, start, assume(less(0, apply(g, b))), order));
  REFUSES(Theorem::intermediate_value(smooth, start, end, assume(less(b, a))));
  REFUSES(Theorem::intermediate_value(smooth, start, end, assume(at_most(a, b))));
}

TEST_CASE("finite sets") {
  const Theorem some = assume(finite(t, less(0, t)));
  REFUSES(Theorem::finite_part(some, assume(for_all(t, implies(less(0, t), less(1, t))))));
  REFUSES(Theorem::finite_part(some, assume(implies(less(1, t), less(0, t)))));
  REFUSES(Theorem::finite_part(assume(negation(finite(t, less(0, t)))),
                               assume(for_all(t, implies(less(1, t), less(0, t))))));
  REFUSES(Theorem::finite_union(some, assume(for_all(t, less(1, t)))));
  CHECK(Theorem::finite_part(some, assume(for_all(t, implies(less(1, t), less(0, t))))).conclusion() ==
        finite(s, less(1, s)));
}
