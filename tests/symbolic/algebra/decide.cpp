#include "symbolic/algebra/decide.hpp"

#include <doctest/doctest.h>

#include "model/flows.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/normal_form.hpp"
#include "tests/symbolic/algebra/letters.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::algebra;
using namespace stickslip::symbolic::algebra::letters;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::pow;
using GiNaC::sin;
using GiNaC::tan;

namespace {

Truth truth(const ex& left, const ex& right) {
  return decide_equal(left, right).verdict.truth;
}

}  // namespace

TEST_CASE("identities that hold are proved") {
  CHECK(truth(pow(sin(w * t), 2) + pow(cos(w * t), 2), 1) == Truth::proved);
  CHECK(truth(sin(w * (t + s)), sin(w * t) * cos(w * s) + cos(w * t) * sin(w * s)) == Truth::proved);
  CHECK(truth(cos(3 * phi), 4 * pow(cos(phi), 3) - 3 * cos(phi)) == Truth::proved);
  CHECK(truth(2 * sin(w * t / 2) * cos(w * t / 2), sin(w * t)) == Truth::proved);
  CHECK(truth(tan(w * t / 2), (1 - cos(w * t)) / sin(w * t)) == Truth::proved);
  CHECK(truth(cos(phi + GiNaC::Pi), -cos(phi)) == Truth::proved);
  CHECK(truth(sin(phi - 3 * GiNaC::Pi / 2), cos(phi)) == Truth::proved);
  CHECK(truth(sin(w1 * (2 * GiNaC::Pi / w - tau)) * cos(w1 * tau) +
                  cos(w1 * (2 * GiNaC::Pi / w - tau)) * sin(w1 * tau),
              sin(2 * GiNaC::Pi * w1 / w)) == Truth::proved);
  CHECK(truth(t * (cos(w1 * t) + 1) - t, t * cos(w1 * t)) == Truth::proved);
}

TEST_CASE("identities that need (39) are proved, and those that do not leave it closed") {
  CHECK(decide_equal(chi * eta, w1 * w1 + w2 * w2 - 1).verdict.truth == Truth::proved);
  CHECK(decide_equal(chi * eta, w1 * w1 + w2 * w2 - 1).opened == std::set<std::string>{"39"});
  CHECK(decide_equal(l1 * l2, -eta).verdict.truth ==
        Truth::proved);  // eigenvectors are orthogonal: 1 + l1 l2/eta = 0
  CHECK(decide_equal(l1 * cos(w1 * t) - cos(w1 * t) * l1, 0).opened.empty());
}

TEST_CASE("definitions are opened only when an identity needs them") {
  const std::vector<Definition> definitions{{"a", {{symbol("q1"), w * t}}},
                                            {"b", {{symbol("q2"), 1 / (w - w1)}}}};
  CHECK(decide_equal(symbol("q1") + symbol("q2"), symbol("q2") + w * t, definitions).opened ==
        std::set<std::string>{"a"});
  const Decision both = decide_equal(symbol("q1") * symbol("q2"), w * t / (w - w1), definitions);
  CHECK(both.verdict.truth == Truth::proved);
  CHECK(both.opened == std::set<std::string>{"a", "b"});
  REQUIRE(both.nonzero.size() == 1);
  CHECK((both.nonzero[0] - (w - w1)).expand() * (both.nonzero[0] - (w1 - w)).expand() == 0);
}

TEST_CASE("what does not hold is refuted with a witness that excludes it") {
  const ex left = sin(w1 * t) * sin(w2 * t);
  const ex right = cos(w1 * t) * cos(w2 * t);
  const Decision decision = decide_equal(left, right);
  REQUIRE(decision.verdict.truth == Truth::refuted);
  const Witness& witness = *decision.verdict.witness;
  CHECK_FALSE(witness.left.overlaps(witness.right));
  const WorkingPrecision precision(512);
  BallValues values;
  for (const Coordinate& coordinate : witness.point) {
    values[symbol(coordinate.name)] = Ball(coordinate.value);
  }
  CHECK(evaluate(left, values).overlaps(witness.left));
  CHECK(evaluate(right, values).overlaps(witness.right));
  CHECK_FALSE(evaluate(left, values).overlaps(evaluate(right, values)));
}

TEST_CASE("a difference that is tiny everywhere is still refuted") {
  CHECK(truth(cos(w * t) + pow(ex(10), -60) * sin(t), cos(w * t)) == Truth::refuted);
}

TEST_CASE("outside its domain the procedure says so") {
  CHECK(truth(GiNaC::exp(t), GiNaC::exp(s)) == Truth::undecided);
  CHECK(truth(GiNaC::sqrt(t * t), t) == Truth::undecided);
  CHECK(truth(cos(phi + 1), cos(phi)) == Truth::undecided);
  CHECK(truth(cos(GiNaC::Pi * t / (t + 1)), 0) == Truth::undecided);
  CHECK(truth(1 / (pow(sin(t), 2) + pow(cos(t), 2) - 1), 0) == Truth::undecided);
}

TEST_CASE("every entry of a matrix counts, and is named") {
  symbolic::algebra::Matrix left = symbolic::algebra::Matrix::Constant(2, 2, t);
  symbolic::algebra::Matrix right = left;
  CHECK(decide_equal(left, right).verdict.truth == Truth::proved);
  right(1, 0) = s;
  const Decision decision = decide_equal(left, right);
  CHECK(decision.verdict.truth == Truth::refuted);
  CHECK(decision.verdict.witness->component == "(2,1)");
}

TEST_CASE("the same witness on every run") {
  const auto once = decide_equal(w * t, w + t).verdict.reason;
  CHECK(once == decide_equal(w * t, w + t).verdict.reason);
}
