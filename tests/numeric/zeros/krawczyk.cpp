// Krawczyk's test: it proves what is there, refutes what is not, and never proves a mutant.
#include "numeric/zeros/krawczyk.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"

using namespace stickslip;
using namespace stickslip::numeric::zeros;

namespace {

// x² + y² = 4, x y = 1: a zero with x = (√6 + √2)/2, y = (√6 - √2)/2.
struct Circle {
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& v) const {
    return {T(v(0) * v(0) + v(1) * v(1) - T(4)), T(v(0) * v(1) - T(1))};
  }
};

// A double zero at (0, 0).
struct Tangent {
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& v) const {
    return {T(v(1) - v(0) * v(0)), v(1)};
  }
};

Box<2> exact_zero() {
  const Ball a = sqrt(Ball(6));
  const Ball b = sqrt(Ball(2));
  return {(a + b) / Ball(2), (a - b) / Ball(2)};
}

}  // namespace

TEST_CASE("a simple zero is proved, enclosed and unique in a larger box") {
  const auto floats = newton<double, 2>(Circle{}, Eigen::Vector2d(2, 0.5), 10);
  REQUIRE(floats);
  const ZeroProof<2> proof =
      prove_zero_by_inflation<2>(Circle{}, Box<2>(Ball((*floats)(0)), Ball((*floats)(1))));
  REQUIRE(proof.verdict.truth == Truth::proved);
  for (int i = 0; i < 2; ++i) {
    CHECK(proof.box(i).overlaps(exact_zero()(i)));
    CHECK((proof.box(i).radius() - Ball(1e-12)).is_negative());
    CHECK(proof.box(i).is_interior_to(proof.unique(i)));
  }
}

TEST_CASE("refinement reaches the asked bits and stays right") {
  const ZeroProof<2> proof = prove_zero_by_inflation<2>(Circle{}, midpoint<2>(exact_zero()));
  for (const long bits : {64L, 128L, 256L, 1024L, 4096L}) {
    CAPTURE(bits);
    const Box<2> fine = refine<2>([] { return Circle{}; }, proof.box, bits);
    CHECK(radius_exponent<2>(fine) <= -bits);
    const WorkingPrecision precision(bits + 64);
    CHECK(fine(0).overlaps(exact_zero()(0)));
    CHECK(fine(1).overlaps(exact_zero()(1)));
  }
}

TEST_CASE("mutants of a proof are never proved") {
  const Box<2> zero = exact_zero();
  const Box<2> good = box_around<2>(zero, 1e-3);
  REQUIRE(krawczyk_test<2>(Circle{}, good).verdict.truth == Truth::proved);
  for (int i = 0; i < 2; ++i) {
    Box<2> moved = good;
    moved(i) += Ball(1e-2);  // ten radii
    CHECK(krawczyk_test<2>(Circle{}, moved).verdict.truth == Truth::refuted);
    Box<2> shrunk = good;  // away from the zero: from its centre + 1/4 radius up
    shrunk(i) = zero(i).midpoint() + Ball::hull(Ball(0.25e-3), Ball(1e-3));
    CHECK(krawczyk_test<2>(Circle{}, shrunk).verdict.truth != Truth::proved);
  }
}

TEST_CASE("a double zero is undecided, not proved and not refuted") {
  const Box<2> at_zero = box_around<2>(Box<2>(Ball(0), Ball(0)), 1e-3);
  CHECK(krawczyk_test<2>(Tangent{}, at_zero).verdict.truth == Truth::undecided);
  CHECK(prove_zero_by_inflation<2>(Tangent{}, Box<2>(Ball(0), Ball(0))).verdict.truth != Truth::proved);
}

TEST_CASE("a box of two zeros is not proved to hold one") {
  const Box<2> both(Ball::hull(Ball(0.1), Ball(2.5)), Ball::hull(Ball(0.1), Ball(2.5)));
  CHECK(krawczyk_test<2>(Circle{}, both).verdict.truth == Truth::undecided);
}
