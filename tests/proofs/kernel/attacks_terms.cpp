// Attacks on the language: names, sorts, shapes, substitution, definitions: each would let a false sequent
// through if it were not refused.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

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

TEST_CASE("what is built alike is one term, and what only looks alike is not") {
  const auto named = [](const std::string& name) {
    const Variable bound{name};
    return for_all(bound, less(0, bound));
  };
  CHECK(named("a") == named("b"));
  CHECK(to_string(named("a")) == "for all a: (0 < a)");  // each with its own hint
  CHECK(to_string(named("b")) == "for all b: (0 < b)");
  CHECK(to_string(for_all(y, less(x, y))) == "for all y: (x < y)");
  CHECK(to_string(exists(y, for_all(x, less(x, y)))) == "there is y: for all x: (x < y)");
  CHECK(Term(x) + y == Term(x) + y);
  CHECK_FALSE(Term(x) + y == Term(y) + x);
  const Variable column{"x", {Sort::real, 2, 1}};
  CHECK_FALSE(Term(x) == Term(column));
  CHECK_FALSE(power(x, 2) == power(x, 3));
  CHECK_FALSE(entry(column, 0) == entry(column, 1));
  CHECK_FALSE(matrix(1, 2, {x, y}) == matrix(2, 1, {x, y}));
  const Definition d("f", {x}, x), e("f", {x}, Term(x) + 1), g("f", {y}, y);
  CHECK_FALSE(d({y}) == e({y}));
  CHECK_FALSE(d({y}) == g({y}));  // another parameter's name: another definition
  CHECK(d({y}) == Definition("f", {x}, x)({y}));
  CHECK((Term(x) + 1).variables() == Variables{x});
  CHECK(((Term(x) + 1) * (Term(y) + 2)).variables() == Variables{x, y});
}

TEST_CASE("fresh names cannot be guessed: every name a rule makes up is bound at once") {
  for (const std::string name : {"t1", "t2", "t3", "symbol1", "c0", "s0"}) {
    const Variable guess{name};
    const Theorem slope = Theorem::differentiate(lambda(t, Term(t) * guess), 0);
    CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(slope.conclusion().parts()[2], guess))));
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
  // One name with two shapes, in one sequent.
  const Variable x_column{"x", {Sort::real, 2, 1}};
  REFUSES(assume(all({equal(x, 0), equal(x_column, zero(x_column.type))})));
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
  REFUSES(Theorem::trichotomy(body.parts()[0], 0));
  REFUSES(zero_product(body.parts()[0], x));
  REFUSES(Theorem::differentiate(lambda(t, t), body.parts()[0]));
  REFUSES(Theorem::sign(less(body.parts()[0], 1)));
  REFUSES(Definition("d", {y}, body.parts()[0]));
  REFUSES(replaced(equal(x, y), x, body.parts()[0]));
}

TEST_CASE("definitions") {
  const Definition square("square", {x}, power(x, 2)), other("square", {y}, power(y, 3));
  REFUSES(square({v}));
  REFUSES(square({}));
  REFUSES(square({x, y}));
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
  // A part that stands in two places, in one of them under a binder more: for all c: c + 1 < 0, and for all
  // y: c + 1 < y. Were it replaced once for both, the second would say y + 1 < y.
  const Definition twice("twice", {x}, all({less(Term(x) + 1, 0), for_all(y, less(Term(x) + 1, y))}));
  CHECK(unfold(for_all(c, twice({c})), {twice}) ==
        for_all(c, all({less(Term(c) + 1, 0), for_all(y, less(Term(c) + 1, y))})));
  // An argument that is not used is looked at for divisors all the same.
  const Definition one("one", {x}, 1);
  CHECK(Theorem::combination(equal(one({1 / Term(y)}), 1), {}, {one}).hypotheses() == Formulas{differ(y, 0)});
  // An unknown definition says nothing, but equal arguments give equal values.
  REFUSES(Theorem::combination(equal(square({x}), power(x, 2))));
  REFUSES(Theorem::combination(equal(square({x}), square({y}))));
  CHECK(Theorem::combination(equal(square({Term(x) / x}), square({1}))).hypotheses() ==
        Formulas{differ(x, 0)});
}
