// Terms as Coq reads them.
#include "proofs/certificates/coq_terms.hpp"

#include <doctest/doctest.h>

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::certificates;

namespace {

const Variable x{"x"}, y{"y"}, A{"A", real_matrix(2, 2)}, f{"f", function_of_time(4, 1)};

}  // namespace

TEST_CASE("one constructor is always one symbol, so that putting in a value commutes with writing") {
  CHECK(coq(Term(x) - y) == "(x - y)");
  CHECK(coq(substitute(Term(x) + y, {{y, Term(-1) * Term(x)}})) == "(x - x)");
  CHECK(coq(Term(x) / y) == "(x / y)");
  CHECK(coq(Term(x) * inverse(y)) == coq(Term(x) / y));
  CHECK(coq(Term(stickslip::Rational(-3, 10))) == "((-3) / 10)");
  CHECK(coq(Term(A) * A) == "(A ** A)");
  CHECK(coq(Term(x) * A) == "(x *m A)");
  CHECK(coq(matrix(1, 1, {x})) == "x");  // a matrix of one entry is a number
  CHECK(coq(inverse(A)) == "(minv A)");
  CHECK(coq(entry(apply(f, x), 2)) == "(ent 2 0 (f x))");
}

TEST_CASE("only the parentheses that Coq needs") {
  CHECK(coq_statement(Term(x) * (Term(y) + x)) == "x * (y + x)");
  CHECK(coq_statement(Term(x) - (Term(y) - x)) == "x - (y - x)");
  CHECK(coq_statement(Term(x) / (Term(y) / x)) == "x / (y / x)");
  CHECK(coq_statement(power(Term(x) + y, 2)) == "(x + y) ^ 2");
  CHECK(coq_statement(power(power(x, 2), 3)) == "(x ^ 2) ^ 3");
  CHECK(coq_statement(inverse(x) * Term(y)) == "/ x * y");
  CHECK(coq_statement(cos(Term(x) * y)) == "cos (x * y)");
  CHECK(coq_statement(Term(A) - Term(x) * A) == "A -m x *m A");
  CHECK(coq_statement(between(x, y, 1)) == "x < y < 1");
  CHECK(coq_statement(all({less(x, y), less(x, 1)})) == "x < y /\\ x < 1");
  CHECK(coq_statement(implies(implies(less(x, y), less(y, x)), negation(equal(x, y)))) ==
        "(x < y -> y < x) -> x <> y");
  CHECK(coq_statement(any({all({less(x, y), less(x, 1)}), less(y, x)})) == "(x < y /\\ x < 1) \\/ y < x");
  CHECK(binders({{"x"}, {"y"}, {"X", function_of_time(4, 1)}}) == "(x y : R) (X : R -> Mat 4 1)");
}

TEST_CASE("quantifiers name what they bind, and nothing is captured") {
  const Formula less_than_x = for_all(x, less(x, y));
  CHECK(coq(less_than_x) == "(forall x : R, x < y)");
  // The bound x is another one than the x put in for y.
  CHECK(coq(substitute(less_than_x, {{y, x}})) == "(forall x_ : R, x_ < x)");
  CHECK(coq(finite(x, equal(x, y))) == "(finite (fun x : R => x = y))");
}

TEST_CASE("different names stay different, and no name means something of Coq's") {
  CHECK(identifier("omega1") == "omega1");
  CHECK(identifier("R") != "R");
  CHECK(identifier("PI") != "PI");
  CHECK(identifier("forall") != "forall");
  const std::vector<std::string> names{"R",  "R'",  "v_R", "x",   "x'",  "x1",
                                       "1x", "x_1", "x 1", "x-1", "v_x", "#"};
  std::set<std::string> identifiers;
  for (const std::string& name : names) {
    identifiers.insert(identifier(name));
  }
  CHECK(identifiers.size() == names.size());
}

TEST_CASE("a definition says its parameters, the shape of its value and its body") {
  const Definition square("square", {x}, power(x, 2));
  CHECK(coq_definition(square) == "Definition square (x : R) : R :=\n  x ^ 2.\n");
  std::vector<Definition> found;
  collect_definitions(Definition("twice", {x}, Term(2) * square({x}))({y}), found);
  REQUIRE(found.size() == 2);
  CHECK(found[0].name() == "square");
}
