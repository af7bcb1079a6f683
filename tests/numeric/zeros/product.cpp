// Products of matrices of balls: of all shapes and orders of storage, with all members of their factors.
#include <doctest/doctest.h>

#include <random>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::zeros {
namespace {

using Matrix = BallMatrix<Eigen::Dynamic>;

Matrix drawn(std::mt19937_64& engine, Eigen::Index rows, Eigen::Index columns) {
  std::uniform_int_distribution<int> whole(-9, 9);
  return Matrix::NullaryExpr(rows, columns, [&] { return Ball(whole(engine)); });
}

// Exactly, number by number.
template <class A, class B>
void check_product(const A& a, const B& b) {
  const auto found = product(a, b);
  REQUIRE(found.rows() == a.rows());
  REQUIRE(found.cols() == b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index k = 0; k < b.cols(); ++k) {
      Ball sum(0);
      for (Eigen::Index l = 0; l < a.cols(); ++l) {
        sum += a(i, l) * b(l, k);
      }
      CHECK(found(i, k).is_exact());
      CHECK(is_zero(Ball(found(i, k) - sum)));
    }
  }
}

TEST_CASE("products of matrices of balls have sums of products for entries, however the factors are stored") {
  std::mt19937_64 engine(1);
  const Matrix a = drawn(engine, 3, 5), b = drawn(engine, 5, 4), c = drawn(engine, 4, 5);
  check_product(a, b);
  check_product(b.transpose(), a.transpose());
  check_product(a, c.transpose());
  check_product(a.row(1), b);
  check_product(a, b.col(2));
  check_product(a.row(2), b.col(0));
  check_product(a.rightCols(3), b.bottomRows(3));
  check_product(a.middleCols(1, 2), c.transpose().topRows(2));
  const Eigen::Matrix<Ball, 1, Eigen::Dynamic> row = a.row(0);
  check_product(row, b);
  const Eigen::Matrix<Ball, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_rows = b;
  check_product(a, by_rows);
  check_product(by_rows.transpose(), a.transpose());
  check_product(a.leftCols(0), b.topRows(0));
}

TEST_CASE("a product of wide matrices holds those of all members") {
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix a = drawn(engine, 4, 4), b = drawn(engine, 4, 4);
  const Matrix member_a = a, member_b = b;
  for (Matrix * wide : {&a, &b}) {
    for (Eigen::Index i = 0; i < wide->size(); ++i) {
      Ball& x = wide->data()[i];
      x = Ball::hull(x, Ball(x + Ball(uniform(engine))));
    }
  }
  const Matrix all = product(a, b), one = product(member_a, member_b);
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    CHECK(all.data()[i].contains(one.data()[i]));
  }
}

}  // namespace
}  // namespace stickslip::numeric::zeros
