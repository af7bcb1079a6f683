#include "symbolic/algebra/derive.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "model/flows.hpp"
#include "symbolic/algebra/symbols.hpp"
#include "tests/symbolic/algebra/letters.hpp"

using namespace stickslip;
using namespace stickslip::symbolic::algebra;
using namespace stickslip::symbolic::algebra::letters;
using GiNaC::ex;

namespace {

Matrix4 derivative(const Matrix4& m) {
  return m.unaryExpr([](const ex& e) { return ex(e.diff(GiNaC::ex_to<GiNaC::symbol>(t))); });
}

// Whether both sides, with (39), are the same numbers at some points, to many digits: what the exponentials
// are for all values is claims 6.H and 10.Gamma.
bool agree(const ex& left, const ex& right) {
  const WorkingPrecision precision(256);
  const Ball tiny = Ball(1) / Ball(1L << 60);
  bool all = true;
  for (const long k : {1, 2, 3}) {
    const BallValues here{{w1, Ball(Rational(k, 5))},
                          {w2, Ball(Rational(7 + k, 5))},
                          {t, Ball(Rational(9, 4 + k))},
                          {s, Ball(Rational(2 + k, 3))}};
    const Ball gap = evaluate(in_frequencies(left - right), here);
    all = all && gap.contains_zero() && (tiny - gap.radius()).is_positive();
  }
  return all;
}

bool agree(const Matrix4& left, const Matrix4& right) {
  return std::equal(left.data(), left.data() + left.size(), right.data(),
                    [](const ex& a, const ex& b) { return agree(a, b); });
}

}  // namespace

TEST_CASE("Vieta's equations give back (39)") {
  const Inverted solution = solve_vieta(w1, w2);
  const ex polynomial = characteristic_polynomial(model::stiffness<ex>(solution.chi, solution.eta), s);
  CHECK(agree(polynomial, (s * s - w1 * w1) * (s * s - w2 * w2)));
  CHECK(agree(solution.chi, chi));
  CHECK(agree(solution.eta, eta));
  CHECK_FALSE(agree(solution.eta, chi));
}

TEST_CASE("the derived exponentials solve their systems, and are the model's") {
  const Inverted solution = solve_vieta(w1, w2);
  const Matrix4 slip = first_order(model::stiffness<ex>(solution.chi, solution.eta));
  const Matrix4 H = exponential(slip, {{w1, w2}, 0}, t);
  CHECK(agree(derivative(H), Matrix4(slip * H)));
  CHECK(agree(H, Matrix4(model::H<ex>(model::modes_of<ex>(chi, w1, w2), t))));
  const Matrix4 stick = first_order(model::matrix<ex>(1, -chi, 0, 0));
  const Matrix4 Gamma = exponential(stick, {{ex(1)}, 2}, t);
  CHECK(agree(derivative(Gamma), Matrix4(stick * Gamma)));
  CHECK(agree(Gamma, Matrix4(model::Gamma<ex>(chi, t))));
  CHECK_FALSE(agree(H, Gamma));
  for (const Matrix4& flow : {H, Gamma}) {
    CHECK(agree(Matrix4(flow.unaryExpr([](const ex& e) { return ex(e.subs(t == 0)); })),
                Matrix4(Matrix4::Identity())));
  }
}

TEST_CASE("a spectrum that is not the matrix's is refused") {
  const Matrix4 stick = first_order(model::matrix<ex>(1, -chi, 0, 0));
  CHECK_THROWS_AS((void)exponential(stick, {{ex(2)}, 2}, t), InternalError);
}
