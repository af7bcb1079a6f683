// Attacks on numbers in balls: each would let a false sequent through if it were not refused.
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using namespace stickslip::proofs::tactics;
using stickslip::Rational;

namespace {

Term column(const std::vector<Term>& entries) {
  return matrix(static_cast<int>(entries.size()), 1, entries);
}

}  // namespace

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
  const Term v0 = entry(v, 0), v1 = entry(v, 1);
  REFUSES(Theorem::one_zero(x, power(X, 2) - 1, {{-2, 3}}));  // Newton's step from the middle stays inside
  REFUSES(Theorem::one_zero(x, X * sin(X), {{-1, 4}}));
  REFUSES(Theorem::one_zero(v, matrix(2, 1, {power(v0, 2) - 1, v1 - v0}), {{-2, 3}, {-2, 3}}));
  REFUSES(Theorem::one_zero(x, X + 0 / X, {{-1, 2}}));
  // Slopes whose balls contain 0, beside others.
  const Interval side{Rational(-1, 2), Rational(3, 4)};
  CHECK(Theorem::one_zero(v, matrix(2, 1, {v1 + v0 * v0 / 4, v0 + v1 * v1 / 4}), {side, side})
            .hypotheses()
            .empty());
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
  // More unknowns than a search takes: the last equation says nothing new, or has no zero.
  const Variable five{"five", real_matrix(5, 1)};
  const auto system = [&](const Term& last) {
    return matrix(5, 1,
                  {entry(five, 0) + entry(five, 4), entry(five, 1) - entry(five, 2), sin(entry(five, 2)),
                   entry(five, 3) + entry(five, 4), last});
  };
  const Box cube(5, Interval{-1, 1});
  CHECK_NOTHROW(static_cast<void>(
      Theorem::one_zero(five, system(entry(five, 4)), Box(5, Interval{Rational(-1, 2), Rational(1, 2)}))));
  REFUSES(Theorem::one_zero(five, system(entry(five, 0) - entry(five, 3)), cube));
  REFUSES(Theorem::one_zero(five, system(entry(five, 4) - 2), cube));
  REFUSES(Theorem::one_zero(x, X, {{-1, Rational("10000000000")}}));
}

TEST_CASE("zeros inside the unit circle") {
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
  // In ranges: for all values, and only of variables that have one.
  const Rational half(1, 2), minus_half(-1, 2);
  CHECK(Theorem::jury(column({x, 1}), {{x, {minus_half, half}}}).hypotheses() ==
        Formulas{at_most(minus_half, x), at_most(x, half)});
  REFUSES(Theorem::jury(column({x, 1}), {{x, {minus_half, 1}}}));
  REFUSES(Theorem::jury(column({x, 1}), {{x, {-1, half}}}));
  REFUSES(Theorem::jury(column({x, 1}), {{x, {half, minus_half}}}));
  REFUSES(Theorem::jury(column({x, 1}), {{y, {minus_half, half}}}));
  REFUSES(Theorem::jury(column({half, x}), {{x, {0, 1}}}));
  REFUSES(Theorem::jury(column({0, 0 * (1 / Term(x)), 1}), {{x, {-1, 1}}}));
}

TEST_CASE("numbers in a bad state") {
  Rational none(1);
  none.get_den() = 0;
  const Rational minus_one(1, -1), minus_two(2, -1);
  // The sign of such a number is that of its numerator to GMP: 0 < -1.
  REFUSES(Theorem::order(less(0, -1), {Positive{{}, minus_one, 1}}));
  REFUSES(Theorem::order(at_most(0, -2), {Positive{{}, minus_two, 1}}));
  REFUSES(Theorem::order(less(0, 1), {Positive{{}, none, 1}}));
  REFUSES(Theorem::sign(less(0, x), {{x, {minus_two, minus_one}}}));
  REFUSES(Theorem::sign(less(0, x), {{x, {minus_one, minus_two}}}));
  REFUSES(Theorem::sign(less(0, x), {{x, {none, 1}}}));
  REFUSES(Theorem::sign(less(0, x), {{x, {1, none}}}));
  REFUSES(Theorem::sign(less(0, none)));
  REFUSES(Theorem::sign(less(0, minus_one)));
  REFUSES(Theorem::jury(column({x, 1}), {{x, {none, 0}}}));
  REFUSES(Theorem::one_zero(x, Term(x) - 1, {{none, 2}}));
  REFUSES(Theorem::one_zero(x, Term(x) - 1, {{minus_two, minus_one}}));
  REFUSES(Theorem::one_zero(x, Term(x) - 1, {{Rational(2, -4), Rational(4, -4)}}));
  // What is meant is what is used.
  const Theorem below = Theorem::sign(less(x, 0), {{x, {minus_two, minus_one}}});
  CHECK(below.hypotheses() == Formulas{at_most(-2, x), at_most(x, -1)});
  CHECK(Term(Rational(2, 4)) == Term(Rational(1, 2)));
  CHECK(Term(Rational(2, -4)) == Term(Rational(-1, 2)));
  CHECK(Number(Rational(0, -7)) == Number(0));
  CHECK(Theorem::one_zero(x, Term(x) + 1, {{Rational(4, -2), Rational(0, -1)}}).hypotheses().empty());
}

TEST_CASE("numbers that neither FLINT nor the stack can take") {
  Term large = cos(Term(1)), huge = 2;
  for (int i = 0; i < 8; ++i) {
    large = power(large, 256);  // cos(1)^(2^64)
    huge = power(huge, 1000);
  }
  REFUSES(Theorem::combination(equal(1 / large, 2 / (2 * large))));
  REFUSES(Theorem::combination(equal(huge, huge + 0)));
  REFUSES([] {
    Term deep = x;
    for (int i = 0; i < 200000; ++i) {
      deep = deep + y;
    }
    return deep;
  }());
  // A term that is short because its parts are shared: each is looked at once.
  Term doubled = x;
  for (int i = 0; i < 60; ++i) {
    doubled = doubled + doubled;
  }
  CHECK(Theorem::combination(equal(doubled / doubled, 1)).hypotheses() == Formulas{differ(doubled, 0)});
  // Too many terms.
  std::vector<Term> letters;
  for (int i = 0; i < 12; ++i) {
    letters.emplace_back(Variable{"x" + std::to_string(i)});
  }
  REFUSES(Theorem::combination(equal(power(sum(letters), 40), 0)));
}

TEST_CASE("nodes made by hand") {
  REFUSES(Node::make({.kind = Kind::sum, .parts = {}}));
  REFUSES(Node::make({.kind = Kind::less, .parts = {1}}));
  REFUSES(Node::make({.kind = Kind::apply, .parts = {Term(f)}}));
  REFUSES(Node::make({.kind = Kind::number, .parts = {}}));
  REFUSES(Node::make({.kind = Kind::power, .parts = {Term(x)}}));
  REFUSES(Node::make({.kind = Kind::bound, .parts = {}, .value = -1}));
  REFUSES(Node::make({.kind = Kind::bound, .parts = {}, .value = Rational(1, 2)}));
  REFUSES(Node::make({.kind = Kind::bound, .parts = {}, .value = mpz_class("18446744073709551616")}));
  REFUSES(Node::make({.kind = Kind::defined, .parts = {}}));
  REFUSES(Node::make({.kind = Kind::variable, .parts = {1}, .name = "x"}));
  // What make() computes is not taken from outside: this is an open term of type real.
  const Term open =
      Node::make({.kind = Kind::bound, .parts = {}, .value = 0, .type = truth_value, .hash = 0, .loose = 0});
  CHECK_FALSE(open.is_closed());
  CHECK(open.type() == real_number);
  REFUSES(Theorem::assume(less(open, 0)));
}
