#include "model/linear.hpp"

#include <doctest/doctest.h>

using namespace stickslip::model;

TEST_CASE("the inverse of a matrix without special entries") {
  const Matrix2<double> m = matrix<double>(2, 3, 5, 11);
  const Matrix2<double> inverse_of_m = inverse<double>(m);
  CHECK(inverse_of_m(0, 0) == doctest::Approx(11.0 / 7));
  CHECK(inverse_of_m(0, 1) == doctest::Approx(-3.0 / 7));
  CHECK(inverse_of_m(1, 0) == doctest::Approx(-5.0 / 7));
  CHECK(inverse_of_m(1, 1) == doctest::Approx(2.0 / 7));
}

TEST_CASE("blocks and stacks put their parts where they say") {
  const Matrix4<double> m = blocks<double>(matrix<double>(1, 2, 3, 4), matrix<double>(5, 6, 7, 8),
                                           matrix<double>(9, 10, 11, 12), matrix<double>(13, 14, 15, 16));
  CHECK(m(0, 1) == 2);
  CHECK(m(1, 2) == 7);
  CHECK(m(2, 1) == 10);
  CHECK(m(3, 3) == 16);
  const Vector4<double> v = stack<double>({1, 2}, {3, 4});
  CHECK(v(1) == 2);
  CHECK(v(2) == 3);
}
