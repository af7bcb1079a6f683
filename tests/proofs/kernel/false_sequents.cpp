// The false sequents that a prover of this project once let through, by class: each call must be refused, or
// the theorem must hold the missing condition among its hypotheses.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::kernel::paper;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

namespace {

const Variable tau1{"tau1"}, z10{"z10"}, q2{"q2"}, us1{"us"}, side_x{"side_x"}, side_y{"side_y"},
    Theta{"Theta"};

}  // namespace

TEST_CASE("class 1: a divisor is on record before anything is cancelled") {
  const Theorem product = Theorem::assume(equal(Term(tau1) * z10, 0));
  SUBCASE("tau1 z10 = 0 |- z10 = 0") {
    REFUSES(Theorem::combination(equal(z10, 0), {{product}}));
    const Theorem theorem = Theorem::combination(equal(z10, 0), {{product, 1 / Term(tau1)}});
    CHECK(theorem.hypotheses().contains(differ(tau1, 0)));
    const Theorem cases = detach(zero_product(tau1, z10), product);
    CHECK(cases.conclusion() == any({equal(tau1, 0), equal(z10, 0)}));
    REFUSES(Theorem::consequence({cases}, equal(z10, 0)));
  }
  SUBCASE("the divisor written as a part of the multiplier, of the premise, and of the goal") {
    const Term hidden = Term(z10) * (1 / (Term(tau1) * z10));
    CHECK(Theorem::combination(equal(z10, 0), {{product, hidden}})
              .hypotheses()
              .contains(differ(Term(tau1) * z10, 0)));
    const Theorem divided = Theorem::assume(equal(Term(tau1) / tau1 * z10, 0));
    CHECK(Theorem::combination(equal(z10, 0), {{divided}}).hypotheses().contains(differ(tau1, 0)));
    CHECK(Theorem::combination(equal(Term(tau1) / tau1, 1)).hypotheses() == Formulas{differ(tau1, 0)});
    CHECK(Theorem::combination(equal(inverse(tau1) * tau1, 1)).hypotheses() == Formulas{differ(tau1, 0)});
    CHECK(Theorem::combination(equal(0 / Term(tau1), 0)).hypotheses() == Formulas{differ(tau1, 0)});
  }
  SUBCASE("q2 omega sin phi = 0 |- sin phi = 0") {
    const Theorem rows = Theorem::assume(equal(Term(q2) * omega * sin(phi), 0));
    REFUSES(Theorem::combination(equal(sin(phi), 0), {{rows}}));
    const Theorem theorem =
        by_combination(equal(sin(phi), 0), {{rows, 1 / (Term(q2) * omega)}}, {}, {above(0, omega)});
    CHECK(theorem.hypotheses().contains(differ(q2, 0)));
    CHECK(theorem.hypotheses().contains(less(0, omega)));
  }
  SUBCASE("37.p: 1 - omega") {
    const Theorem q = Theorem::assume(equal(Term(q2) * chi, Term(y) * (1 - Term(omega))));
    const Theorem theorem =
        Theorem::combination(equal(y, Term(q2) * chi / (1 - Term(omega))), {{q, -1 / (1 - Term(omega))}});
    CHECK(theorem.hypotheses().contains(differ(1 - Term(omega), 0)));
  }
  SUBCASE("A5.cos: z2B - z20") {
    const Theorem rows = Theorem::assume(equal((Term(x) - y) * (cos(a) + cos(b)), 0));
    REFUSES(Theorem::combination(equal(cos(a), -cos(b)), {{rows}}));
    const Theorem theorem = Theorem::combination(equal(cos(a), -cos(b)), {{rows, 1 / (Term(x) - y)}});
    CHECK(theorem.hypotheses().contains(differ(Term(x) - y, 0)));
  }
}

TEST_CASE("class 2: what a name means is part of it, and carries no theorem along") {
  // (57): H(-tau1) applied to the state after the overshoot is not H(tau) applied to the one before.
  const Variable Z0{"Z0", {Sort::real, 4, 1}}, Zbar0{"Zbar0", {Sort::real, 4, 1}};
  const Formula claim = equal((H(tau) + E) * Z0, (H(-Term(tau1)) + E) * Zbar0);
  REFUSES(Theorem::combination(claim, {}, {H_of}));
  REFUSES(Theorem::combination(claim));
  SUBCASE("a second definition of the name is another one") {
    const Definition one("c", {}, 1), two("c", {}, 2);
    REFUSES(Theorem::combination(equal(one({}), two({})), {}));
    REFUSES(
        Theorem::convert(Theorem::combination(equal(one({}), 1), {}, {one}), equal(two({}), 1), {one, two}));
    REFUSES(Theorem::combination(equal(one({}), 1), {}, {two}));
  }
  SUBCASE("a definition cannot hide a variable") {
    REFUSES(Definition("F0", {omega}, cos(phi)));
    REFUSES(Definition("F0", {}, Term(x)));
    REFUSES(Definition("F0", {x}, for_all(y, equal(x, a))));
    REFUSES(Definition("twice", {x, Variable{"x", {Sort::real, 2, 1}}}, x));
    REFUSES(Definition("f", {x}, lambda(t, Term(t) + x)));
  }
}

TEST_CASE("class 3: a closed form is so on its range and for its initial state") {
  const Variable Z{"Z", function_of_time(4)}, W{"W", function_of_time(4)};
  const Formula closed_form = for_all(t, implies(within(0, t, tau), equal(apply(Z, t), H(t) * apply(Z, 0))));
  const Theorem known = Theorem::assume(closed_form);
  SUBCASE("not outside the range") {
    const Theorem anywhere = Theorem::specialize(known, s);
    CHECK(anywhere.conclusion() == implies(within(0, s, tau), equal(apply(Z, s), H(s) * apply(Z, 0))));
    REFUSES(Theorem::consequence({anywhere}, equal(apply(Z, s), H(s) * apply(Z, 0))));
    REFUSES(detach(anywhere, Theorem::assume(within(0, s, 2 * Term(tau)))));
  }
  SUBCASE("(5) and (8) of two motions are of two functions: no L d0 = 0") {
    const Variable L{"L", {Sort::real, 4, 1}};
    const Theorem slip = Theorem::assume(equal(apply(Z, t), H(t) * apply(Z, 0)));
    const Theorem over = Theorem::assume(equal(apply(W, t), H(t) * apply(W, 0) + L));
    REFUSES(Theorem::combination(equal(L, zero(L.type)), {{slip, -1}, {over}}, {H_of}));
    REFUSES(Theorem::combination(equal(L, zero(L.type)), {{over}, {slip, -1}}));
  }
  SUBCASE("of one motion they hold on phases that do not overlap, and nothing follows before the second") {
    const Variable L{"L", {Sort::real, 4, 1}};
    const Theorem over = Theorem::assume(
        for_all(t, implies(within(tau, t, Theta), equal(apply(Z, t), H(t) * apply(Z, 0) + L))));
    const Theorem first = at(known, s, Theorem::assume(within(0, s, tau)));
    const Theorem second = at(over, s, Theorem::assume(within(tau, s, Theta)));
    const Theorem both_at_s = Theorem::combination(equal(L, zero(L.type)), {{second, -1}, {first}});
    CHECK(both_at_s.hypotheses().contains(within(tau, s, Theta)));
    CHECK(both_at_s.hypotheses().contains(within(0, s, tau)));
  }
  SUBCASE("(13) is no definition: it stays a hypothesis of what uses it") {
    const Theorem ends = Theorem::assume(equal(apply(Z, tau), E * apply(Z, 0)));
    const Theorem used = Theorem::combination(equal(entry(apply(Z, tau), 2), entry(apply(Z, 0), 2)),
                                              {{ends, matrix(1, 4, {0, 0, 1, 0})}});
    CHECK(used.hypotheses().contains(ends.conclusion()));
    REFUSES(Theorem::combination(equal(entry(apply(Z, tau), 2), entry(apply(Z, 0), 2))));
  }
}

TEST_CASE("class 4: zeros of sin and cos lie in a range that was proved") {
  const Theorem equation = Theorem::assume(equal(sin(Term(omega) * tau), 0));
  const auto lower = [](const Term& from, const Term& x_) { return Theorem::assume(less(from * pi(), x_)); };
  const auto upper = [](const Term& x_, const Term& to) { return Theorem::assume(less(x_, to * pi())); };
  const Term phase = Term(omega) * tau;
  SUBCASE("tau = 3 pi/omega beside Theta = 2 pi/omega: both bounds stay hypotheses") {
    const Theorem theorem = Theorem::zeros_between(equation, lower(0, phase), upper(phase, 2));
    CHECK(theorem.hypotheses().contains(less(phase, Term(2) * pi())));
    CHECK(theorem.hypotheses().contains(less(Term(0) * pi(), phase)));
    const Theorem wide = Theorem::zeros_between(equation, lower(0, phase), upper(phase, 4));
    CHECK(wide.conclusion() ==
          any({equal(phase, Term(1) * pi()), equal(phase, Term(2) * pi()), equal(phase, Term(3) * pi())}));
  }
  SUBCASE("bounds must be strict, of the same number, and numbers times pi") {
    REFUSES(
        Theorem::zeros_between(equation, Theorem::assume(at_most(Term(0) * pi(), phase)), upper(phase, 2)));
    REFUSES(
        Theorem::zeros_between(equation, lower(0, phase), Theorem::assume(at_most(phase, Term(2) * pi()))));
    REFUSES(Theorem::zeros_between(equation, lower(0, tau), upper(phase, 2)));
    REFUSES(Theorem::zeros_between(equation, upper(phase, 2), lower(0, phase)));
    REFUSES(Theorem::zeros_between(equation, lower(x, phase), upper(phase, 2)));
    REFUSES(Theorem::zeros_between(Theorem::assume(equal(sin(phase), 1)), lower(0, phase), upper(phase, 2)));
    REFUSES(Theorem::zeros_between(Theorem::assume(differ(sin(phase), 0)), lower(0, phase), upper(phase, 2)));
    REFUSES(Theorem::zeros_between(equation, lower(0, phase), upper(phase, 100000)));
  }
  SUBCASE("the ends themselves are not among the zeros, and none is lost at fractions") {
    const Theorem open = Theorem::zeros_between(equation, lower(-1, phase), upper(phase, 1));
    CHECK(open.conclusion() == any({equal(phase, Term(0) * pi())}));
    const Theorem fractions =
        Theorem::zeros_between(equation, lower(Rational(-1, 2), phase), upper(phase, Rational(3, 2)));
    CHECK(fractions.conclusion() == any({equal(phase, Term(0) * pi()), equal(phase, Term(1) * pi())}));
    const Theorem cosine = Theorem::zeros_between(Theorem::assume(equal(cos(phase), 0)),
                                                  lower(Rational(-1, 2), phase), upper(phase, 2));
    CHECK(cosine.conclusion() ==
          any({equal(phase, Rational(1, 2) * pi()), equal(phase, Rational(3, 2) * pi())}));
  }
}

TEST_CASE("class 5: a letter is tied to what it stands for by a hypothesis or not at all") {
  // A5.sides: delta = x - y is nowhere said, so nothing of x and y follows.
  const Variable delta{"delta"};
  const Theorem sides = Theorem::assume(equal(delta, 0));
  REFUSES(Theorem::combination(equal(side_x, side_y), {{sides}}));
  const Theorem tied = Theorem::assume(equal(delta, Term(side_x) - side_y));
  const Theorem theorem = Theorem::combination(equal(side_x, side_y), {{sides}, {tied, -1}});
  CHECK(theorem.hypotheses().contains(tied.conclusion()));
  SUBCASE("side_x = 1, side_y = -1 |- 2 = 0") {
    const Theorem one = Theorem::assume(equal(side_x, 1)), other = Theorem::assume(equal(side_y, -1));
    REFUSES(Theorem::combination(equal(2, 0), {{one}, {other}}));
    REFUSES(Theorem::combination(equal(2, 0), {{one, x}, {other, y}}));
    REFUSES(Theorem::combination(equal(2, 0)));
  }
  SUBCASE("at one instant is not at all times") {
    const Variable f{"f", function_of_time()};
    const Theorem instant = Theorem::assume(equal(apply(f, t), 0));
    REFUSES(Theorem::generalize(instant, t));
    REFUSES(Theorem::combination(equal(apply(f, s), 0), {{instant}}));
    REFUSES(Theorem::specialize(instant, s));
    const Theorem moved = Theorem::instantiate(instant, {{t, s}});
    CHECK(moved.hypotheses() == Formulas{equal(apply(f, s), 0)});
  }
}

TEST_CASE("class 6: theorems of calculus with their conditions") {
  const Variable f{"f", function_of_time()}, g{"g", function_of_time()};
  const auto inside = [](const Variable& h, const Term& from, const Term& to, const Term& rate) {
    return Theorem::assume(for_all(t, implies(between(from, t, to), derivative(h, t, rate))));
  };
  const auto smooth = [](const Variable& h, const Term& from, const Term& to) {
    return Theorem::assume(continuous(h, from, to));
  };
  SUBCASE("mean value: a < b, the same function and the same ends everywhere") {
    const Theorem order = Theorem::assume(less(a, b));
    CHECK_NOTHROW(
        static_cast<void>(Theorem::mean_value(smooth(f, a, b), inside(f, a, b, apply(g, t)), order)));
    REFUSES(
        Theorem::mean_value(smooth(f, a, b), inside(f, a, b, apply(g, t)), Theorem::assume(at_most(a, b))));
    REFUSES(Theorem::mean_value(smooth(f, a, b), inside(f, a, b, apply(g, t)), Theorem::assume(less(b, a))));
    REFUSES(Theorem::mean_value(smooth(f, 0, -Term(tau)), inside(f, 0, -Term(tau), 0),
                                Theorem::assume(less(0, tau))));
    REFUSES(Theorem::mean_value(smooth(f, 0, 0), inside(f, 0, 0, 0), Theorem::assume(at_most(0, 0))));
    REFUSES(Theorem::mean_value(smooth(g, a, b), inside(f, a, b, 0), order));
    REFUSES(Theorem::mean_value(smooth(f, a, 0), inside(f, a, b, 0), order));
    REFUSES(Theorem::mean_value(smooth(f, a, b), inside(f, a, 0, 0), order));
    REFUSES(Theorem::mean_value(smooth(f, a, 0), inside(f, a, b, 0), Theorem::assume(less(a, 0))));
    REFUSES(Theorem::mean_value(inside(f, a, b, 0), inside(f, a, b, 0), order));
  }
  SUBCASE("[0, 0]: its order cannot be had, and would be a contradiction") {
    REFUSES(Theorem::order(less(0, 0), {{{}, 1, 0}}));
    REFUSES(Theorem::order(less(0, 0), {}));
    REFUSES(Theorem::sign(less(0, 0)));
  }
  SUBCASE("mean value is of numbers: a vector turns") {
    const Variable F2{"F2", function_of_time(2)};
    REFUSES(Theorem::mean_value(smooth(F2, a, b), inside(F2, a, b, zero({Sort::real, 2, 1})),
                                Theorem::assume(less(a, b))));
  }
  SUBCASE("constant: the value is literally 0, of the same function on the same ends") {
    CHECK_NOTHROW(static_cast<void>(Theorem::constant(smooth(f, a, b), inside(f, a, b, 0))));
    REFUSES(Theorem::constant(smooth(f, a, b), inside(f, a, b, Term(x) - x)));
    REFUSES(Theorem::constant(smooth(g, a, b), inside(f, a, b, 0)));
    REFUSES(Theorem::constant(smooth(f, a, Theta), inside(f, a, b, 0)));
    REFUSES(Theorem::constant(smooth(f, 0, b), inside(f, a, b, 0)));
    REFUSES(Theorem::constant(inside(f, a, b, 0), inside(f, a, b, 0)));
    const Theorem at_one_point = Theorem::assume(implies(between(a, t, b), derivative(f, t, 0)));
    REFUSES(Theorem::constant(smooth(f, a, b), at_one_point));
  }
  SUBCASE("a derivative that vanishes but at infinitely many times does not make a constant") {
    const Formula bad = negation(derivative(f, t, 0));
    CHECK_NOTHROW(static_cast<void>(
        Theorem::constant(smooth(f, a, b), Theorem::assume(finite(t, all({between(a, t, b), bad}))))));
    REFUSES(Theorem::constant(smooth(f, a, b), Theorem::assume(finite(t, all({between(a, t, s), bad})))));
    REFUSES(Theorem::constant(smooth(f, a, b), Theorem::assume(for_all(t, implies(between(a, t, b), bad)))));
    REFUSES(Theorem::constant(smooth(f, a, b),
                              Theorem::assume(negation(finite(t, all({between(a, t, b), bad}))))));
  }
  SUBCASE("1 = 0 by the decrease of another function") {
    REFUSES(Theorem::combination(equal(1, 0), {{Theorem::assume(equal(apply(f, a), apply(f, b)))}}));
    REFUSES(Theorem::order(less(apply(g, b), apply(g, a)),
                           {{{Theorem::assume(less(apply(f, b), apply(f, a)))}}}));
  }
}

TEST_CASE("class 7: composition") {
  const Variable f{"f", function_of_time()};
  SUBCASE("nothing is rewritten by what is no equation") {
    const Theorem claim = Theorem::assume(equal(x, 1));
    REFUSES(Theorem::replace(Theorem::assume(differ(x, y)), a, equal(a, 1), claim));
    REFUSES(Theorem::replace(Theorem::assume(less(x, y)), a, equal(a, 1), claim));
    REFUSES(Theorem::replace(Theorem::assume(implies(equal(x, y), equal(x, y))), a, equal(a, 1), claim));
    REFUSES(Theorem::replace(Theorem::assume(equal(y, x)), a, equal(a, 1), claim));
    REFUSES(Theorem::combination(equal(x, y), {{Theorem::assume(less(x, y))}}));
    REFUSES(Theorem::combination(equal(x, y), {{Theorem::assume(at_most(x, y))}}));
    REFUSES(Theorem::combination(equal(x, y), {{Theorem::assume(differ(x, y))}}));
    REFUSES(Theorem::combination(differ(x, y), {}));
    REFUSES(Theorem::order(less(x, y), {{{Theorem::assume(differ(x, y))}}}));
  }
  SUBCASE("t -> -t under a derivative: the chain rule and its premise") {
    const Theorem rate = Theorem::assume(derivative(f, t, x));
    const Term turned = lambda(t, apply(f, -Term(t)));
    REFUSES(Theorem::differentiate(turned, t, {rate}));
    REFUSES(Theorem::differentiate(turned, -Term(t), {rate}));  // -(-t) is t by an equation only
    REFUSES(Theorem::differentiate(lambda(t, apply(f, 2 * t)), t, {rate}));
    const Theorem at_minus = Theorem::assume(derivative(f, -Term(t), x));
    const Theorem right = Theorem::differentiate(turned, t, {at_minus});
    const Term value = right.conclusion().parts()[2];
    CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(value, -Term(x)))));
    REFUSES(Theorem::combination(equal(value, x)));
  }
  SUBCASE("4294967297 tau is not tau, nor are their phases or powers") {
    const Term many = 4294967297L * Term(tau);
    REFUSES(Theorem::combination(equal(many, tau)));
    REFUSES(Theorem::combination(equal(cos(many), cos(tau))));
    REFUSES(Theorem::combination(equal(cos(Term(tau) / 4294967296L), cos(4294967296L * Term(tau)))));
    REFUSES(Theorem::combination(equal(sin(4294967296L * Term(tau)), 0)));
    REFUSES(Theorem::combination(equal(cos(4294967297L * pi()), 1)));
    CHECK_NOTHROW(static_cast<void>(Theorem::combination(equal(cos(4294967297L * pi()), -1))));
    REFUSES(power(tau, 4294967297L));
    REFUSES(power(tau, -1));
  }
  SUBCASE("tau -> 0 reaches everything or nothing") {
    const Theorem theorem = Theorem::assume(equal(H(tau) * Variable{"Z", {Sort::real, 4, 1}}, F(tau)));
    const Theorem moved = Theorem::instantiate(theorem, {{tau, 0}});
    CHECK_FALSE(moved.conclusion().variables().contains(tau));
    CHECK_FALSE(moved.hypotheses().begin()->variables().contains(tau));
  }
  SUBCASE("no rule sheds an assumption") {
    const Theorem theorem = Theorem::assume(equal(x, 0));
    CHECK(Theorem::instantiate(theorem, {{x, y}}).hypotheses() == Formulas{equal(y, 0)});
    CHECK(Theorem::convert(theorem, equal(x, 0), {}).hypotheses() == Formulas{equal(x, 0)});
    CHECK(Theorem::cut(theorem, Theorem::assume(equal(y, 0))).hypotheses().contains(equal(y, 0)));
    CHECK(Theorem::consequence({theorem}, any({equal(x, 0), falsity})).hypotheses() == Formulas{equal(x, 0)});
  }
}

TEST_CASE("class 8: a refutation's witness satisfies what it refutes from") {
  // cos² tau = 1 where sin tau = 0: true. A counterexample must have sin tau = 0.
  const Formula claim = for_all(tau, implies(equal(sin(tau), 0), equal(power(cos(tau), 2), 1)));
  const Theorem instance = Theorem::sign(differ(power(cos(Term(1)), 2), 1));
  REFUSES(refuted(claim, 1, instance));
  const Theorem with_premise =
      Theorem::consequence({instance, Theorem::assume(equal(sin(Term(1)), 0))},
                           negation(implies(equal(sin(Term(1)), 0), equal(power(cos(Term(1)), 2), 1))));
  CHECK(refuted(claim, 1, with_premise).hypotheses() == Formulas{equal(sin(Term(1)), 0)});
  const Theorem premise = Theorem::assume(equal(sin(tau), 0));
  CHECK_NOTHROW(
      static_cast<void>(Theorem::combination(equal(power(cos(tau), 2), 1), {{premise, -sin(tau)}})));
  SUBCASE("a true refutation") {
    const Formula everywhere = for_all(tau, equal(cos(tau), 1));
    CHECK(refuted(everywhere, 1, Theorem::sign(differ(cos(Term(1)), 1))).hypotheses().empty());
    REFUSES(refuted(everywhere, 0, Theorem::sign(differ(cos(Term(1)), 1))));
  }
}
