// Further attacks on the kernel, rule by rule: each would let a false sequent through if it were not refused.
#include "tests/proofs/kernel/refuses.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::methods;
using stickslip::Rational;

namespace {

const Variable x{"x"}, y{"y"}, t{"t"}, s{"s"}, a{"a"}, b{"b"}, c{"c"};
const Variable f{"f", function_of_time()}, g{"g", function_of_time()};
const Variable n{"n", integer_number}, m{"m", integer_number};
const Variable M{"M", {Sort::real, 2, 2}}, v{"v", {Sort::real, 2, 1}};
const Formula falsity = any({});

Theorem assume(const Formula& formula) {
  return Theorem::assume(formula);
}

}  // namespace

TEST_CASE("names: a variable that looks like something else is a variable") {
  REFUSES(Theorem::sign(less(0, Variable{"pi"})));
  REFUSES(Theorem::combination(equal(Variable{"pi"}, pi())));
  REFUSES(Theorem::combination(equal(sin(Variable{"pi"}), 0)));
  REFUSES(Theorem::combination(equal(Variable{"1"}, 1)));
  REFUSES(Theorem::combination(equal(Variable{"+(x,-(x,),)"}, 0)));
  REFUSES(Theorem::combination(equal(Variable{"(x + -1*x)"}, 0)));
  REFUSES(Theorem::combination(equal(Variable{"x "}, x)));
  REFUSES(Theorem::combination(equal(Variable{to_string(Term(x) - x)}, Term(x) - x)));
  REFUSES(Theorem::combination(equal(Variable{"c0"}, cos(x))));
  REFUSES(Term(Variable{""}));
  // Printed alike, but two terms.
  const Definition d("f", {x}, x);
  const Term applied = apply(f, y), defined = d({y});
  CHECK(to_string(applied) != "");
  CHECK_FALSE(applied == defined);
  REFUSES(Theorem::combination(equal(applied, defined), {}, {d}));
}

TEST_CASE("fresh names cannot be guessed: every name a rule makes up is bound at once") {
  for (const std::string name : {"t1", "t2", "t3", "symbol1", "c0", "s0"}) {
    const Variable guess{name};
    const Theorem slope = Theorem::differentiate(lambda(t, Term(t) * guess), 0);
    CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(slope.conclusion().parts()[2], guess))));
    const Theorem sine = Theorem::zeros_of_sine(guess);
    CHECK(sine.conclusion().variables() == Variables{guess});
    const Theorem smooth = Theorem::continuity(lambda(t, 1 / (Term(t) - guess)), 0, guess);
    CHECK(smooth.hypotheses().begin()->kind() == Kind::for_all);
    CHECK(smooth.hypotheses().begin()->variables() == Variables{guess});
    const Theorem no_rate = assume(for_all(s, implies(between(a, s, guess), derivative(f, s, 0))));
    const Theorem constant = Theorem::constant(assume(continuous(f, a, guess)), no_rate);
    CHECK(constant.conclusion().variables() == Variables{a, f, guess});
  }
  CHECK_FALSE(fresh(real_number, {x, Variable{"t1"}}).name == "t1");
  // Not even under another type.
  CHECK_FALSE(fresh(real_number, {Variable{"t1", {Sort::real, 2, 1}}}).name == "t1");
}

TEST_CASE("shapes and sorts are checked in every construction") {
  REFUSES(Term(M) + v);
  REFUSES(Term(v) * M);
  REFUSES(Term(v) * v);
  REFUSES(equal(M, v));
  REFUSES(equal(x, v));
  REFUSES(less(v, v));
  REFUSES(at_most(M, 1));
  REFUSES(inverse(v));
  REFUSES(x / Term(M));
  REFUSES(cos(M));
  REFUSES(power(M, 2));
  REFUSES(entry(M, 2, 0));
  REFUSES(entry(M, 0, -1));
  REFUSES(entry(v, 0, 1));
  REFUSES(matrix(2, 2, {1, 2, 3}));
  REFUSES(matrix(2, 1, {v, v}));
  REFUSES(matrix(0, 0, {}));
  REFUSES(matrix(65536, 65536, {}));
  REFUSES(Term(Variable{"huge", {Sort::real, 1 << 20, 1 << 20}}));
  REFUSES(Term(Variable{"A", truth_value}));
  REFUSES(Term(Variable{"k", {Sort::integer, 2, 2}}));
  REFUSES(apply(x, t));
  REFUSES(apply(f, v));
  REFUSES(apply(f, f));
  REFUSES(Term(f) + f);
  REFUSES(equal(f, g));
  REFUSES(negation(x));
  REFUSES(all({equal(x, x), x}));
  REFUSES(implies(equal(x, x), x));
  REFUSES(lambda(t, equal(t, 0)));
  REFUSES(lambda(t, f));
  REFUSES(lambda(v, entry(v, 0)));
  REFUSES(lambda(n, Term(n)));
  REFUSES(finite(n, equal(n, n)));
  REFUSES(for_all(x, x));
  REFUSES(for_all(Variable{"A", truth_value}, equal(x, x)));
  REFUSES(derivative(x, t, 0));
  REFUSES(derivative(f, v, 0));
  REFUSES(derivative(f, t, v));
  REFUSES(continuous(f, v, v));
  REFUSES(inside_unit_circle(M));
  REFUSES(inside_unit_circle(x));
  REFUSES(sum({}));
  REFUSES(Term(Rational(1, 0)));
  CHECK(Term(Rational(2, 4)) == Term(Rational(1, 2)));
}

TEST_CASE("substitution: types, capture, and one name for two things") {
  const Theorem theorem = assume(equal(x, y));
  REFUSES(Theorem::instantiate(theorem, {{x, v}}));
  REFUSES(Theorem::instantiate(theorem, {{x, f}}));
  REFUSES(Theorem::instantiate(theorem, {{x, equal(x, x)}}));
  REFUSES(Theorem::instantiate(assume(equal(n, m)), {{n, Rational(1, 2)}}));
  REFUSES(Theorem::instantiate(assume(equal(n, m)), {{n, x}}));
  REFUSES(Theorem::instantiate(assume(equal(n, m)), {{n, Term(m) / 2}}));
  CHECK_NOTHROW(static_cast<void>(Theorem::instantiate(theorem, {{x, n}})));
  // One name with two shapes, in one sequent.
  const Variable x_column{"x", {Sort::real, 2, 1}};
  REFUSES(assume(all({equal(x, 0), equal(x_column, zero(x_column.type))})));
  REFUSES(Theorem::weaken(theorem, {equal(x_column, zero(x_column.type))}));
  REFUSES(Theorem::cut(assume(equal(x_column, zero(x_column.type))), theorem));
  REFUSES(Theorem::instantiate(theorem, {{y, entry(x_column, 0)}}));
  // for all x there is y: y = x + 1; with y for x nothing is captured.
  const Formula next = exists(y, equal(y, Term(x) + 1));
  const Formula moved = Theorem::instantiate(assume(next), {{x, y}}).conclusion();
  CHECK(moved.variables() == Variables{y});
  CHECK_FALSE(opened(moved, x) == equal(x, Term(x) + 1));
  CHECK(opened(moved, x) == equal(x, Term(y) + 1));
  CHECK(for_all(x, equal(x, x)) == for_all(y, equal(y, y)));
  CHECK_FALSE(for_all(x, equal(x, y)) == for_all(y, equal(y, y)));
  // At once, not one after the other.
  const Theorem swapped = Theorem::instantiate(assume(less(x, y)), {{x, y}, {y, x}});
  CHECK(swapped.conclusion() == less(y, x));
  // A function by a lambda whose body has the name of a bound time.
  const Formula at_all = for_all(t, equal(apply(f, t), 0));
  const Formula shifted = substitute(at_all, {{f, lambda(s, Term(s) + t)}});
  CHECK(shifted.variables() == Variables{t});
  CHECK(opened(shifted, 5) == equal(Term(5) + t, 0));
  // Under two binders, with a lambda applied to a bound variable.
  const Formula nested = for_all(x, exists(y, equal(apply(f, Term(x) + y), apply(f, x))));
  const Formula filled = substitute(nested, {{f, lambda(s, Term(s) * y)}});
  CHECK(opened(filled, 1) == exists(c, equal((Term(1) + c) * y, Term(1) * y)));
}

TEST_CASE("what is cut out of a binder goes into no other") {
  const Formula body = for_all(x, equal(x, y)).parts()[0];  // #0 = y
  CHECK_FALSE(body.is_closed());
  REFUSES(assume(body));
  REFUSES(for_all(y, body));
  REFUSES(Theorem::consequence({}, implies(body, body)));
  REFUSES(Theorem::combination(equal(body.parts()[0], body.parts()[0])));
  REFUSES(Theorem::instantiate(assume(equal(y, 0)), {{y, body.parts()[0]}}));
  REFUSES(Theorem::specialize(assume(for_all(x, equal(x, y))), body.parts()[0]));
  REFUSES(Theorem::discharge(assume(equal(x, x)), body));
  REFUSES(Theorem::weaken(assume(equal(x, x)), {body}));
  REFUSES(Theorem::trichotomy(body.parts()[0], 0));
  REFUSES(Theorem::zero_product(body.parts()[0], x));
  REFUSES(Theorem::zeros_of_sine(body.parts()[0]));
  REFUSES(Theorem::differentiate(lambda(t, t), body.parts()[0]));
  REFUSES(Theorem::finite_point(body.parts()[0]));
  REFUSES(Theorem::sign(less(body.parts()[0], 1)));
  REFUSES(Definition("d", {y}, body.parts()[0]));
  REFUSES(replaced(equal(x, y), x, body.parts()[0]));
}

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
    REFUSES(Theorem::generalize(Theorem::weaken(Theorem::trichotomy(x, 1), {less(x, y)}), x));
    REFUSES(Theorem::generalize(Theorem::weaken(Theorem::trichotomy(x, 1), {for_all(y, less(x, y))}), x));
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
    REFUSES(Theorem::specialize(assume(for_all(n, equal(n, 0))), Rational(1, 2)));
    REFUSES(Theorem::specialize(assume(for_all(n, equal(n, 0))), x));
    REFUSES(Theorem::specialize(assume(for_all(v, equal(v, zero(v.type)))), M));
    REFUSES(Theorem::specialize(assume(for_all(f, equal(apply(f, 0), 0))), x));
  }
  SUBCASE("there is: the witness has the property, and nothing of it leaks") {
    REFUSES(Theorem::witness(assume(A), exists(x, less(x, 0)), 0));
    REFUSES(Theorem::witness(assume(A), for_all(x, A), x));
    REFUSES(Theorem::witness(assume(A), exists(x, A), y));
    REFUSES(Theorem::witness(assume(equal(Rational(1, 2), 0)), exists(n, equal(n, 0)), Rational(1, 2)));
    const Theorem some = assume(exists(x, A));
    REFUSES(Theorem::choose(some, x, assume(A)));
    REFUSES(Theorem::choose(some, y, assume(B)));
    REFUSES(Theorem::choose(some, y, Theorem::weaken(assume(C), {B, less(y, 1)})));
    REFUSES(Theorem::choose(assume(exists(x, equal(x, y))), y, assume(C)));
    REFUSES(Theorem::choose(assume(for_all(x, A)), y, assume(C)));
    REFUSES(Theorem::choose(some, n, assume(C)));
    REFUSES(Theorem::choose(assume(exists(n, equal(n, 0))), x, assume(C)));
    CHECK(Theorem::choose(some, y, Theorem::weaken(assume(C), {B})).hypotheses() ==
          Formulas{C, exists(x, A)});
  }
  SUBCASE("discharge and cut take away that one hypothesis and no other") {
    const Theorem theorem = Theorem::weaken(assume(A), {B});
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

TEST_CASE("definitions") {
  const Definition square("square", {x}, power(x, 2)), other("square", {y}, power(y, 3));
  REFUSES(square({v}));
  REFUSES(square({}));
  REFUSES(square({x, y}));
  REFUSES(Definition("k", {n}, Term(n))({Rational(1, 2)}));
  REFUSES(Definition("k", {n}, Term(n))({x}));
  REFUSES(Theorem::convert(assume(equal(square({x}), 4)), equal(other({x}), 4), {square, other}));
  REFUSES(Theorem::convert(assume(equal(square({x}), 4)), equal(power(x, 2), 4), {}));
  REFUSES(Theorem::convert(assume(equal(square({x}), 4)), equal(x, 2), {square}));
  CHECK(Theorem::convert(assume(equal(square({x}), 4)), equal(power(x, 2), 4), {square}).hypotheses() ==
        Formulas{equal(square({x}), 4)});
  // The variables of a body are its parameters, whatever stands around.
  const Definition shift("shift", {x}, Term(x) + 1);
  const Formula claim = for_all(x, equal(shift({y}), shift({x})));
  CHECK(unfold(claim, {shift}) == for_all(c, equal(Term(y) + 1, Term(c) + 1)));
  const Definition both("both", {x, y}, Term(x) - y);
  CHECK(unfold(both({y, x}), {both}) == Term(y) - x);
  // A property with a binder in it.
  const Definition bounded("bounded", {f, c}, for_all(t, at_most(apply(f, t), c)));
  CHECK(unfold(bounded({lambda(s, Term(s) * t), t}), {bounded}) == for_all(x, at_most(Term(x) * t, t)));
  // An argument that is not used is looked at for divisors all the same.
  const Definition one("one", {x}, 1);
  CHECK(Theorem::combination(equal(one({1 / Term(y)}), 1), {}, {one}).hypotheses() == Formulas{differ(y, 0)});
  // An unknown definition says nothing, but equal arguments give equal values.
  REFUSES(Theorem::combination(equal(square({x}), power(x, 2))));
  REFUSES(Theorem::combination(equal(square({x}), square({y}))));
  CHECK(Theorem::combination(equal(square({Term(x) / x}), square({1}))).hypotheses() ==
        Formulas{differ(x, 0)});
}

TEST_CASE("divisors hide nowhere") {
  const auto needs = [](const Formula& equation, const Formula& divisor) {
    return Theorem::combination(equation).hypotheses().contains(divisor);
  };
  const Term X = x, Y = y;
  CHECK(needs(equal(X / X, 1), differ(X, 0)));
  CHECK(needs(equal(X - X / Y * Y, 0), differ(Y, 0)));
  CHECK(needs(equal(1 / (1 / X), X), differ(X, 0)));
  CHECK(needs(equal(tan(X) * cos(X), sin(X)), differ(cos(X), 0)));
  CHECK(needs(equal(tan(X) - tan(X), 0), differ(cos(X), 0)));
  CHECK(needs(equal(cos(X * (Y / Y)), cos(X)), differ(Y, 0)));
  CHECK(needs(equal(apply(f, X / X), apply(f, 1)), differ(X, 0)));
  CHECK(needs(equal(entry(matrix(2, 1, {X, 1 / Y}), 0), X), differ(Y, 0)));
  CHECK(needs(equal(inverse(M) * M, identity(2)), differ(determinant(M), 0)));
  CHECK(needs(equal(0 * inverse(M), zero(M.type)), differ(determinant(M), 0)));
  CHECK(needs(equal(X / sin(1 * pi() * Y), X / sin(1 * pi() * Y)), differ(sin(1 * pi() * Y), 0)));
  CHECK(needs(equal(X / (Y - 1) * (Y - 1), X), differ(Y - 1, 0)));
  CHECK(needs(equal(1 / sin(Term(1)) * sin(Term(1)), 1), differ(sin(Term(1)), 0)));
  const Theorem premise = assume(equal(X / Y, 1));
  CHECK(Theorem::combination(equal(X, Y), {{premise, Y}}).hypotheses().contains(differ(Y, 0)));
  const Theorem ratio = assume(less(0, X / Y));
  CHECK(Theorem::order(less(0, X * Y), {{{ratio}, 1, 1}}, {{assume(equal(power(Y, 2), 1)), X / Y, 1}})
            .hypotheses()
            .contains(differ(Y, 0)));
  // A divisor that is zero itself.
  REFUSES(Theorem::combination(equal((X - X) / (X - X), 1)));
  REFUSES(Theorem::combination(equal(1 / sin(pi()) * 0, 0)));
  REFUSES(Theorem::combination(equal(1 / (power(sin(X), 2) + power(cos(X), 2) - 1), 0)));
  REFUSES(Theorem::combination(
      equal(inverse(matrix(2, 2, {X, X, X, X})) * matrix(2, 2, {X, X, X, X}), identity(2))));
  CHECK(Theorem::combination(equal(X / 2 + X / 2, X)).hypotheses().empty());
  CHECK(Theorem::combination(equal(X / pi() * pi(), X)).hypotheses().empty());
}

TEST_CASE("the normal form knows sine and cosine, and no more than is true") {
  const Term X = x, Y = y;
  REFUSES(Theorem::combination(equal(cos(X), sin(X))));
  REFUSES(Theorem::combination(equal(cos(X + Y), cos(X) + cos(Y))));
  REFUSES(Theorem::combination(equal(cos(X) * cos(X) + sin(Y) * sin(Y), 1)));
  REFUSES(Theorem::combination(equal(cos(X / 2), cos(X))));
  REFUSES(Theorem::combination(equal(cos(2 * X), 2 * cos(X))));
  REFUSES(Theorem::combination(equal(sin(-X), sin(X))));
  REFUSES(Theorem::combination(equal(cos(X + pi()), cos(X))));
  REFUSES(Theorem::combination(equal(sin(pi() / 2), 0)));
  REFUSES(Theorem::combination(equal(cos(Term(3)), -1)));
  REFUSES(Theorem::combination(equal(pi(), Rational(22, 7))));
  REFUSES(Theorem::combination(equal(pi(), 3)));
  REFUSES(Theorem::combination(equal(cos(cos(X)), sin(cos(X)))));
  REFUSES(Theorem::combination(equal(cos(cos(X)), cos(X))));
  REFUSES(Theorem::combination(equal(cos(sin(X)), X)));
  REFUSES(Theorem::combination(equal(apply(f, X), apply(g, X))));
  REFUSES(Theorem::combination(equal(apply(f, X), apply(f, Y))));
  REFUSES(Theorem::combination(equal(apply(f, cos(X)), apply(f, sin(X)))));
  REFUSES(Theorem::combination(equal(Term(M) * M, power(entry(M, 0, 0), 2) * identity(2))));
  const Variable N{"N", {Sort::real, 2, 2}};
  REFUSES(Theorem::combination(equal(Term(M) * N, Term(N) * M)));
  REFUSES(Theorem::combination(equal(inverse(Term(M) * N), inverse(M) * inverse(N))));
  CHECK_NOTHROW(
      static_cast<void>(Theorem::combination(equal(inverse(Term(M) * N), inverse(N) * inverse(M)))));
  CHECK_NOTHROW(static_cast<void>(
      Theorem::combination(equal(cos(X / 3) * 4 * power(cos(X / 3), 2), cos(X) + 3 * cos(X / 3)))));
  CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(apply(f, (X + Y) - Y), apply(f, X)))));
  CHECK_NOTHROW(static_cast<void>(
      Theorem::combination(equal(apply(f, power(cos(X), 2) + power(sin(X), 2)), apply(f, 1)))));
}

TEST_CASE("order: signs and strictness") {
  const Theorem weak = assume(at_most(0, x)), strict = assume(less(0, y)), lower = assume(less(x, 0));
  REFUSES(Theorem::order(less(0, x), {{{weak}}}));
  REFUSES(Theorem::order(less(0, Term(x) * y), {{{weak, strict}}}));
  REFUSES(Theorem::order(less(0, power(x, 2)), {{{}, 1, x}}));
  REFUSES(Theorem::order(less(x, 0), {{{weak}, -1}}));
  REFUSES(Theorem::order(at_most(x, 0), {{{weak}, -1}}));
  REFUSES(Theorem::order(less(0, 0), {{{strict}, 0}}));
  REFUSES(Theorem::order(at_most(0, x), {{{lower}}}));
  REFUSES(Theorem::order(less(0, Term(x) * y), {{{lower, strict}}}));
  REFUSES(Theorem::order(less(0, Term(y) * y - 1), {{{strict, strict}}}));
  REFUSES(Theorem::order(equal(x, x), {}));
  REFUSES(Theorem::order(equal(0, y), {{{strict}}}));
  REFUSES(Theorem::order(derivative(f, 0, y), {{{strict}}}));
  REFUSES(Theorem::order(differ(0, y), {{{strict}}}));
  REFUSES(Theorem::order(at_most(0, entry(v, 0)), {{{}, 1, v}}));
  REFUSES(Theorem::order(less(0, Term(x) + y), {{{strict}}, {{lower}}}));
  REFUSES(Theorem::order(at_most(y, x), {{{assume(negation(less(x, y)))}}}));
  CHECK(Theorem::order(less(0, Term(x) + y), {{{strict}}, {{weak}}}).hypotheses().size() == 2);
  REFUSES(Theorem::zero_product(M, M));
  REFUSES(Theorem::trichotomy(M, M));
  // Matrices have zero divisors: M² = 0 says nothing of M by any rule.
  const Theorem nilpotent = assume(equal(Term(M) * M, zero(M.type)));
  REFUSES(Theorem::combination(equal(M, zero(M.type)), {{nilpotent}}));
}

TEST_CASE("integers") {
  REFUSES(Theorem::integer_gap(x, 0));
  REFUSES(Theorem::integer_gap(n, Rational(1, 2)));
  REFUSES(Theorem::integer_gap(n, Term(m) / 2));
  REFUSES(Theorem::integer_gap(n, entry(v, 0)));
  REFUSES(Theorem::integer_gap(n, inverse(n)));
  CHECK((Term(n) * m + 3).type() == integer_number);
  CHECK((Term(n) + x).type() == real_number);
  CHECK((Term(n) / 2).type() == real_number);
  CHECK(Theorem::integer_gap(n, 0).conclusion() == any({at_most(n, 0), at_most(Term(0) + 1, n)}));
}

TEST_CASE("induction") {
  const auto claim = [](const Term& k) { return at_most(0, apply(f, k)); };
  const Variable k{"k", integer_number};
  const Formula whole = for_all(k, claim(k));
  const Theorem start = assume(claim(0));
  const Formula up = implies(claim(k), claim(Term(k) + 1)), down = implies(claim(k), claim(Term(k) - 1));
  CHECK(Theorem::induction(whole, start, assume(for_all(k, all({up, down})))).conclusion() == whole);
  REFUSES(Theorem::induction(whole, start, assume(for_all(k, up))));
  REFUSES(Theorem::induction(whole, start, assume(for_all(k, all({up, up})))));
  REFUSES(Theorem::induction(whole, start, assume(all({up, down}))));
  REFUSES(Theorem::induction(whole, assume(claim(1)), assume(for_all(k, all({up, down})))));
  REFUSES(Theorem::induction(whole, start, assume(for_all(x, substitute(all({up, down}), {{k, m}})))));
  // From integers nothing follows for all reals.
  const Formula reals = for_all(x, claim(x));
  const Formula real_steps =
      for_all(x, all({implies(claim(x), claim(Term(x) + 1)), implies(claim(x), claim(Term(x) - 1))}));
  REFUSES(Theorem::induction(reals, start, assume(real_steps)));
  REFUSES(Theorem::induction(reals, start, assume(for_all(k, all({up, down})))));
}

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
  REFUSES(Theorem::same_derivative(
      known, assume(for_all(n, implies(between(a, n, b), equal(apply(f, n), apply(g, n))))), lower, upper));
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
  REFUSES(Theorem::same_continuity(
      whole, assume(for_all(t, implies(between(a, t, b), equal(apply(f, t), apply(g, t)))))));
  REFUSES(Theorem::same_continuity(
      whole, assume(for_all(t, implies(within(a, t, c), equal(apply(f, t), apply(g, t)))))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(between(a, t, b), derivative(f, t, 0))))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(within(a, t, b), derivative(f, s, 0))))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(within(a, t, t), derivative(f, t, 0))))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(within(a, t, b), derivative(lambda(s, Term(s) * t), t, t))))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(n, implies(within(a, n, b), derivative(f, n, 0))))));
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
  REFUSES(Theorem::same_continuity(rate, agree));
  REFUSES(Theorem::same_derivative(smooth, open_agree, assume(less(c, a)), assume(less(a, x))));
  REFUSES(Theorem::unique_derivative(smooth, assume(continuous(f, a, c))));
  REFUSES(Theorem::unique_derivative(rate, assume(continuous(f, a, c))));
  REFUSES(Theorem::unique_derivative(assume(continuous(f, a, c)), rate));
  REFUSES(Theorem::mean_value(smooth, assume(for_all(t, implies(between(a, t, b), continuous(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(within(a, t, b), continuous(f, t, 0))))));
  REFUSES(Theorem::same_continuity(
      smooth, assume(exists(t, implies(within(a, t, b), equal(apply(f, t), apply(g, t)))))));
  REFUSES(Theorem::same_continuity(
      smooth, assume(for_all(t, all({within(a, t, b), equal(apply(f, t), apply(g, t))})))));
  REFUSES(Theorem::same_continuity(
      smooth, assume(for_all(t, implies(within(a, t, b), less(apply(f, t), apply(g, t)))))));
  REFUSES(Theorem::same_continuity(
      smooth, assume(for_all(t, implies(within(a, t, b), equal(apply(g, t), apply(f, t)))))));
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
  REFUSES(Theorem::differentiable_is_continuous(
      assume(for_all(t, implies(all({at_most(a, s), at_most(t, b)}), derivative(f, t, 0))))));
  // finite, exists and for all have a body alike.
  const Formula positive = less(0, t);
  REFUSES(Theorem::specialize(assume(finite(t, positive)), 0));
  REFUSES(Theorem::witness(assume(positive), finite(t, positive), t));
  REFUSES(Theorem::choose(assume(finite(t, positive)), x, assume(equal(c, 0))));
  REFUSES(Theorem::mean_value(smooth, assume(exists(t, implies(between(a, t, b), derivative(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::mean_value(smooth, assume(finite(t, implies(between(a, t, b), derivative(f, t, 0)))),
                              assume(less(a, b))));
  REFUSES(Theorem::differentiable_is_continuous(
      assume(exists(t, implies(within(a, t, b), derivative(f, t, 0))))));
  REFUSES(Theorem::same_continuity(
      smooth, assume(finite(t, implies(within(a, t, b), equal(apply(f, t), apply(g, t)))))));
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

TEST_CASE("finite sets") {
  const Theorem some = assume(finite(t, less(0, t)));
  REFUSES(Theorem::finite_part(some, assume(for_all(t, implies(less(0, t), less(1, t))))));
  REFUSES(Theorem::finite_part(some, assume(implies(less(1, t), less(0, t)))));
  REFUSES(Theorem::finite_part(assume(negation(finite(t, less(0, t)))),
                               assume(for_all(t, implies(less(1, t), less(0, t))))));
  REFUSES(Theorem::finite_part(some, assume(for_all(n, implies(less(1, n), less(0, n))))));
  REFUSES(Theorem::finite_union(some, assume(for_all(t, less(1, t)))));
  CHECK(Theorem::finite_part(some, assume(for_all(t, implies(less(1, t), less(0, t))))).conclusion() ==
        finite(s, less(1, s)));
}

TEST_CASE("signs in balls") {
  REFUSES(Theorem::sign(less(0, sin(pi()))));
  REFUSES(Theorem::sign(less(sin(pi()), 0)));
  REFUSES(Theorem::sign(differ(sin(pi()), 0)));
  REFUSES(Theorem::sign(at_most(0, sin(pi()))));
  REFUSES(Theorem::sign(less(1, 1)));
  REFUSES(Theorem::sign(less(2, 1)));
  REFUSES(Theorem::sign(less(x, Term(x) + 1)));
  REFUSES(Theorem::sign(less(0, x), {{x, {0, 1}}}));
  REFUSES(Theorem::sign(less(0, power(x, 2) + 1), {{x, {1, 0}}}));
  REFUSES(Theorem::sign(less(0, x), {{y, {1, 2}}}));
  REFUSES(Theorem::sign(less(0, entry(v, 0)), {{v, {1, 2}}}));
  REFUSES(Theorem::sign(less(0, apply(f, 1))));
  REFUSES(Theorem::sign(differ(M, zero(M.type))));
  REFUSES(Theorem::sign(equal(1, 1)));
  REFUSES(Theorem::sign(negation(less(2, 1))));
  REFUSES(Theorem::sign(all({less(1, 2)})));
  REFUSES(Theorem::sign(less(0, 1 / sin(pi()) + 1)));
  REFUSES(Theorem::sign(less(0, 0 * (1 / sin(pi())) + 1)));
  REFUSES(Theorem::sign(less(0, 1 + 0 / Term(x)), {{x, {-1, 1}}}));
  REFUSES(Theorem::sign(less(0, entry(inverse(matrix(2, 2, {1, 1, 1, 1})), 0, 0) * 0 + 1)));
  // More digits of pi than the precision holds, rounded up.
  REFUSES(Theorem::sign(less(Rational(mpz_class("314159265358979323846264338327950288419716939937511"),
                                      mpz_class("100000000000000000000000000000000000000000000000000")),
                             pi()),
                        {}, 64));
  REFUSES(Theorem::sign(less(0, 1), {}, 0));
  REFUSES(Theorem::sign(less(0, 1), {}, 1L << 62));
  // Ends that no double holds: the ball contains the range.
  const Theorem third = Theorem::sign(less(Rational(33, 100), x), {{x, {Rational(1, 3), Rational(1, 3)}}});
  CHECK(third.hypotheses() == Formulas{at_most(Rational(1, 3), x), at_most(x, Rational(1, 3))});
  REFUSES(Theorem::sign(less(Rational(1, 3), x), {{x, {Rational(1, 3), 1}}}));
}

TEST_CASE("zeros in balls") {
  const Term X = x;
  REFUSES(Theorem::one_zero(x, power(X, 2) + 1, {{-1, 1}}));
  REFUSES(Theorem::one_zero(x, power(X, 2), {{-1, 1}}));
  REFUSES(Theorem::one_zero(x, power(X, 2) - 1, {{-2, 2}}));
  REFUSES(Theorem::one_zero(x, X - 1, {{1, 2}}));
  REFUSES(Theorem::one_zero(x, X - 3, {{1, 2}}));
  REFUSES(Theorem::one_zero(x, X - X, {{1, 2}}));
  REFUSES(Theorem::one_zero(x, X / X - X, {{Rational(-1, 2), 2}}));
  REFUSES(Theorem::one_zero(x, X + 0 / X, {{-1, 1}}));
  REFUSES(Theorem::one_zero(x, tan(X) - 1, {{-1, 2}}));
  REFUSES(Theorem::one_zero(x, X - y, {{-1, 1}}));
  REFUSES(Theorem::one_zero(v, matrix(2, 1, {entry(v, 0), entry(v, 0)}), {{-1, 1}, {-1, 1}}));
  REFUSES(Theorem::one_zero(v, entry(v, 0), {{-1, 1}, {-1, 1}}));
  REFUSES(Theorem::one_zero(v, v, {{-1, 1}}));
  REFUSES(Theorem::one_zero(v, v, {{1, -1}, {-1, 1}}));
  REFUSES(Theorem::one_zero(v, v, {{-1, 1}, {-1, 1}, {-1, 1}}));
  REFUSES(Theorem::one_zero(x, X, {}));
  REFUSES(Theorem::one_zero(n, Term(n) - Rational(1, 2), {{0, 1}}));
  REFUSES(Theorem::every_zero(x, power(X, 2) - 1, {{-2, 2}}, {{{Rational(1, 2), Rational(3, 2)}}}));
  REFUSES(Theorem::every_zero(x, power(X, 2) - 1, {{-2, 2}}, {}));
  REFUSES(Theorem::every_zero(x, X - X, {{0, Rational(1, 1024)}}, {}));
  REFUSES(Theorem::every_zero(x, X - 1, {{0, 1}}, {{{Rational(1, 2), 1}}}));
  REFUSES(Theorem::every_zero(x, X - 1, {{0, 1}}, {}));
  REFUSES(Theorem::every_zero(x, power(X, 2), {{-1, 1}}, {{{Rational(-1, 1000), Rational(1, 1000)}}}));
  CHECK(Theorem::every_zero(x, power(X, 2) + 1, {{-1, 1}}, {}).hypotheses().empty());
  // 1/x is not known at 0; that it has no zero near by is no reason.
  REFUSES(Theorem::every_zero(x, 1 / X, {{-1, 1}}, {}));
  REFUSES(Theorem::one_zero(x, X, {{-1, Rational("10000000000")}}));
}

TEST_CASE("zeros inside the unit circle") {
  const auto column = [](const std::vector<Term>& c_) { return matrix(static_cast<int>(c_.size()), 1, c_); };
  REFUSES(Theorem::jury(column({-2, 1})));
  REFUSES(Theorem::jury(column({-1, 1})));
  REFUSES(Theorem::jury(column({1, 0, 1})));
  REFUSES(Theorem::jury(column({0})));
  REFUSES(Theorem::jury(column({0, 0})));
  REFUSES(Theorem::jury(column({Rational(1, 2), 0})));
  REFUSES(Theorem::jury(column({0, 0, 0})));
  REFUSES(Theorem::jury(column({1, -2, 1})));
  REFUSES(Theorem::jury(column({Rational(9, 10), Rational(-21, 10), 1})));
  REFUSES(Theorem::jury(column({x, 1})));
  REFUSES(Theorem::jury(column({Rational(1, 2), -Term(Rational(5, 2)), 1})));
  CHECK(Theorem::jury(column({Rational(1, 2), 1})).hypotheses().empty());
  CHECK(Theorem::jury(column({0, 1})).hypotheses().empty());
  CHECK(Theorem::jury(column({0, 0, 0, 1})).hypotheses().empty());
  CHECK(Theorem::jury(column({Rational(-1, 8), 0, 0, 1})).hypotheses().empty());
}

TEST_CASE("tactics add nothing") {
  REFUSES(by_normal_form(equal(Term(x) / y, x), {}, {above(0, y)}));
  // A domain that does not imply d != 0 leaves it.
  const Theorem divided = Theorem::combination(equal(Term(x) / x, 1));
  CHECK(nonzero(divided, {}).hypotheses() == Formulas{differ(x, 0)});
  CHECK(nonzero(divided, {above(-1, x)}).hypotheses() == Formulas{differ(x, 0)});
  CHECK(nonzero(divided, {above(0, x)}).hypotheses() == Formulas{less(0, x)});
  CHECK(nonzero(divided, {above(0, y)}).hypotheses() == Formulas{differ(x, 0)});
  const Theorem between_one = Theorem::combination(equal((1 - Term(x)) / (1 - Term(x)), 1));
  CHECK(nonzero(between_one, {above(0, x)}).hypotheses() == Formulas{differ(Term(x) - 1, 0)});
  CHECK(nonzero(between_one, {above(0, x), below(x, 1)}).hypotheses() == Formulas{less(x, 1)});
  CHECK(nonzero(between_one, {above(0, x), below(x, 2)}).hypotheses() == Formulas{differ(Term(x) - 1, 0)});
  REFUSES(different(assume(at_most(0, x))));
  REFUSES(symmetric(assume(less(x, y))));
  REFUSES(reflexive(M));
  REFUSES(detach(assume(implies(equal(x, 0), equal(y, 0))), assume(equal(x, 1))));
}
