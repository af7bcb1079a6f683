// Attacks on algebra, order, and the tactics on them: each would let a false sequent through if it
// were not refused.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

TEST_CASE("a square root is of a number that is not negative, and is some number of which no more is known") {
  const Theorem root = Theorem::square_root(x);
  CHECK(root.hypotheses().empty());
  const Variable r{"r"};
  CHECK(root.conclusion() == implies(at_most(0, x), exists(r, all({at_most(0, r), equal(power(r, 2), x)}))));
  REFUSES(Theorem::square_root(M));
  REFUSES(Theorem::square_root(f));
  REFUSES(Theorem::square_root(less(0, x)));
  // No root of -1 without 0 ≤ -1.
  const Theorem minus = Theorem::square_root(-1);
  REFUSES(detach(minus, assume(at_most(0, 1))));
  REFUSES(Theorem::consequence({minus}, minus.conclusion().parts()[1]));
  // What is bound is not what the number is made of: x² = x would be 0 or 1.
  for (const char * name : {"x", "r", "t1", "x'"}) {
    const Variable v{name};
    const Theorem theorem = Theorem::square_root(v);
    CHECK(theorem.conclusion().variables() == Variables{v});
    CHECK(Theorem::instantiate(theorem, {{v, 4}}).conclusion() == Theorem::square_root(4).conclusion());
  }
  // One root is not the other: nothing chosen may stay.
  const Theorem there = detach(root, assume(at_most(0, x)));
  REFUSES(Theorem::choose(there, r, assume(opened(there.conclusion(), r))));
}

TEST_CASE("squares order numbers that are not negative, and no others") {
  const Theorem squares = assume(less(power(x, 2), power(y, 2)));
  CHECK(below_by_squares(squares, assume(at_most(0, y)), x, y).conclusion() == less(x, y));
  REFUSES(below_by_squares(squares, assume(at_most(0, x)), x, y));
  REFUSES(below_by_squares(squares, assume(at_most(y, 0)), x, y));
  REFUSES(below_by_squares(assume(at_most(power(x, 2), power(y, 2))), assume(at_most(0, y)), x, y));
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

TEST_CASE("the normal form knows exponentials, and no more than is true") {
  const Term X = x, Y = y;
  const auto is_proved = [](const Term& left, const Term& right) {
    CHECK(Theorem::combination(equal(left, right)).hypotheses().empty());
  };
  is_proved(exp(X + Y), exp(X) * exp(Y));
  is_proved(exp(-X) * exp(X), 1);
  is_proved(1 / exp(X), exp(-X));
  is_proved(exp(X / 2 - Y / 3), exp(X / 6) * exp(X / 3) / (exp(Y / 6) * exp(Y / 6)));
  is_proved(exp(Term(0)), 1);
  is_proved(exp(Term(Rational(3, 2))) * exp(Term(Rational(1, 2))), exp(Term(2)));
  is_proved(exp(pi() / 2) * exp(pi() / 2), exp(pi()));
  is_proved(exp(X * Y) * cos(X * Y), cos(-X * Y) / exp(-(Y * X)));
  is_proved(X / (3 * pi() * exp(X)) * exp(X) * 3 * pi(), X);
  REFUSES(Theorem::combination(equal(exp(X), 1)));
  REFUSES(Theorem::combination(equal(exp(X), exp(-X))));
  REFUSES(Theorem::combination(equal(exp(X + Y), exp(X) + exp(Y))));
  REFUSES(Theorem::combination(equal(exp(X * Y), exp(X) * exp(Y))));
  REFUSES(Theorem::combination(equal(exp(2 * X), 2 * exp(X))));
  REFUSES(Theorem::combination(equal(exp(X), cos(X) + sin(X))));
  REFUSES(Theorem::combination(equal(exp(2 * pi()), 1)));
  REFUSES(Theorem::combination(equal(exp(pi() / 2), 1)));
  REFUSES(Theorem::combination(equal(exp(Term(1)), Rational(19, 7))));
  REFUSES(Theorem::combination(equal(exp(exp(X)), exp(X))));
  REFUSES(Theorem::combination(equal(apply(f, exp(X)), apply(f, exp(Y)))));
  REFUSES(exp(Term(M)));
  // What stands in the exponent divides; what is an exponential less something may be zero.
  const auto needs = [](const Formula& equation, const Formula& divisor) {
    return Theorem::combination(equation).hypotheses().contains(divisor);
  };
  CHECK(needs(equal(exp(X / Y) * exp(-X / Y), 1), differ(Y, 0)));
  CHECK(needs(equal(1 / (exp(X) - 1) * (exp(X) - 1), 1), differ(exp(X) - 1, 0)));
  CHECK(needs(equal(1 / (X * exp(X)) * X * exp(X), 1), differ(X * exp(X), 0)));
  CHECK(needs(equal(1 / (exp(X) / Y) * exp(X), Y), differ(exp(X) / Y, 0)));
  CHECK(needs(equal(1 / (exp(X) * cos(X)) * exp(X) * cos(X), 1), differ(exp(X) * cos(X), 0)));
  REFUSES(Theorem::combination(equal(1 / (exp(X) * exp(-X) - 1), 0)));
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
  REFUSES(zero_product(M, M));
  REFUSES(Theorem::trichotomy(M, M));
  // Matrices have zero divisors: M² = 0 says nothing of M by any rule.
  const Theorem nilpotent = assume(equal(Term(M) * M, zero(M.type)));
  REFUSES(Theorem::combination(equal(M, zero(M.type)), {{nilpotent}}));
}

TEST_CASE("an inverse is known by a product that is literally the identity") {
  const Variable A{"A", real_matrix(2, 2)}, B{"B", real_matrix(2, 2)}, tall{"tall", real_matrix(2, 1)},
      wide{"wide", real_matrix(1, 2)};
  const Formula product = equal(Term(A) * B, identity(2));
  CHECK(inverse_of(assume(product)).conclusion() == equal(inverse(A), B));
  CHECK(inverse_of(assume(product)).hypotheses() == Formulas{product});
  REFUSES(inverse_of(assume(equal(Term(A) * B, Term(2) * identity(2)))));
  REFUSES(inverse_of(assume(equal(Term(A) * B, matrix(2, 2, {1, 0, 0, 2})))));
  REFUSES(inverse_of(assume(equal(Term(A) + B, identity(2)))));
  REFUSES(inverse_of(assume(equal(identity(2), Term(A) * B))));
  REFUSES(inverse_of(assume(equal(Term(wide) * tall, 1))));  // has a right inverse, is none
  REFUSES(inverse_of(assume(equal(Term(x) * A, identity(2)))));
  REFUSES(inverse_of(assume(implies(product, product))));
}

TEST_CASE("everything numeric is equal to itself, by its structure") {
  CHECK(Theorem::reflexive(1 / Term(x)).hypotheses().empty());
  CHECK(Theorem::reflexive(1 / Term(x)).conclusion() == equal(1 / Term(x), 1 / Term(x)));
  REFUSES(Theorem::reflexive(Variable{"f", function_of_time()}));
  REFUSES(Theorem::reflexive(equal(x, x)));
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
  // What is remembered of a divisor is remembered for these bounds, with what they suppose.
  const Theorem whole = Theorem::combination(equal(Term(x) / x, 1), {});
  const Theorem by_y = weakened(assume(differ(x, 0)), {less(0, y)});
  for (int again = 0; again < 2; ++again) {
    CHECK(nonzero(whole, {}).hypotheses() == Formulas{differ(x, 0)});
    CHECK(nonzero(whole, {above(0, x)}).hypotheses() == Formulas{less(0, x)});
    CHECK(nonzero(whole, {above(1, x)}).hypotheses() == Formulas{less(1, x)});
    CHECK(nonzero(whole, {above(0, y)}).hypotheses() == Formulas{differ(x, 0)});
    CHECK(nonzero(whole, {weakened(above(0, x), {less(0, y)})}).hypotheses() ==
          Formulas{less(0, x), less(0, y)});
    CHECK(nonzero(whole, {by_y}).hypotheses() == Formulas{differ(x, 0)});
  }
  // 0 < a by its factors, each with the sign that is known.
  CHECK(positive(Term(x) / y, {above(0, x), above(0, y)}).conclusion() == less(0, Term(x) / y));
  REFUSES(positive(Term(x) / y, {above(0, x)}));
  REFUSES(positive(Term(x) - y, {above(0, x), above(0, y)}));
  REFUSES(positive(-Term(x), {above(0, x)}));
  REFUSES(positive(Term(x) - x, {above(0, x)}));
  CHECK(positive(power(x, 2), {}).hypotheses() == Formulas{differ(x, 0)});
  REFUSES(inverse_is_positive(assume(less(x, 0))));
  for (const Theorem& factor : factors_differ(assume(differ(Term(x) * (Term(x) - y), 0)))) {
    CHECK(factor.hypotheses() == Formulas{differ(Term(x) * (Term(x) - y), 0)});
  }
  CHECK(factors_differ(assume(differ(Term(x) - x, 0))).empty());
  REFUSES(detach(assume(implies(equal(x, 0), equal(y, 0))), assume(equal(x, 1))));
}
