#include "symbolic/algebra/derive.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "symbolic/algebra/decide.hpp"
#include "tests/symbolic/algebra/letters.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::algebra;
using namespace stickslip::symbolic::algebra::letters;
using GiNaC::ex;

namespace {

symbolic::algebra::Matrix derivative(const Matrix4& m) {
  return symbolic::algebra::Matrix(
      m.unaryExpr([](const ex& e) { return ex(e.diff(GiNaC::ex_to<GiNaC::symbol>(t))); }));
}

}  // namespace

TEST_CASE("Vieta's equations give back (39)") {
  const Inverted solution = solve_vieta(w1, w2);
  const ex polynomial = characteristic_polynomial(model::stiffness<ex>(solution.chi, solution.eta), s);
  CHECK(decide_equal(polynomial, (s * s - w1 * w1) * (s * s - w2 * w2)).verdict.truth == Truth::proved);
  CHECK(decide_equal(solution.chi, chi).verdict.truth == Truth::proved);
  CHECK(decide_equal(solution.eta, eta).verdict.truth == Truth::proved);
}

TEST_CASE("the derived exponentials solve their systems") {
  const Inverted solution = solve_vieta(w1, w2);
  const Matrix4 slip = first_order(model::stiffness<ex>(solution.chi, solution.eta));
  const Matrix4 H = exponential(slip, {{w1, w2}, 0}, t);
  CHECK(decide_equal(derivative(H), symbolic::algebra::Matrix(slip * H)).verdict.truth == Truth::proved);
  const Matrix4 stick = first_order(model::matrix<ex>(1, -chi, 0, 0));
  const Matrix4 Gamma = exponential(stick, {{ex(1)}, 2}, t);
  CHECK(decide_equal(derivative(Gamma), symbolic::algebra::Matrix(stick * Gamma)).verdict.truth ==
        Truth::proved);
  for (const Matrix4& flow : {H, Gamma}) {
    const symbolic::algebra::Matrix start = flow.unaryExpr([](const ex& e) { return ex(e.subs(t == 0)); });
    CHECK(decide_equal(start, symbolic::algebra::Matrix(symbolic::algebra::Matrix::Identity(4, 4)))
              .verdict.truth == Truth::proved);
  }
}

TEST_CASE("the model's H and Gamma are the derived ones") {
  const Inverted solution = solve_vieta(w1, w2);
  const Matrix4 H =
      exponential(first_order(model::stiffness<ex>(solution.chi, solution.eta)), {{w1, w2}, 0}, t);
  const model::Modes<ex> m = model::modes_of<ex>(chi, w1, w2);
  CHECK(decide_equal(symbolic::algebra::Matrix(H), symbolic::algebra::Matrix(model::H<ex>(m, t)))
            .verdict.truth == Truth::proved);
  const Matrix4 Gamma = exponential(first_order(model::matrix<ex>(1, -chi, 0, 0)), {{ex(1)}, 2}, t);
  CHECK(decide_equal(symbolic::algebra::Matrix(Gamma), symbolic::algebra::Matrix(model::Gamma<ex>(chi, t)))
            .verdict.truth == Truth::proved);
}

TEST_CASE("a spectrum that is not the matrix's is refused") {
  const Matrix4 stick = first_order(model::matrix<ex>(1, -chi, 0, 0));
  CHECK_THROWS_AS((void)exponential(stick, {{ex(2)}, 2}, t), InternalError);
}
