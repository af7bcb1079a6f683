// Fixed-size vectors and matrices over any scalar.
//
// A scalar S of the model has + - * /, S(int), and cos and sin found by argument-dependent lookup. It need
// not be ordered. Formulas never mix it with double.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace stickslip::model {

template <class S>
using Vector2 = Eigen::Matrix<S, 2, 1>;
template <class S>
using Vector4 = Eigen::Matrix<S, 4, 1>;
template <class S>
using Matrix2 = Eigen::Matrix<S, 2, 2>;
template <class S>
using Matrix4 = Eigen::Matrix<S, 4, 4>;
// Two 2×2 blocks above each other, as L in (8).
template <class S>
using Matrix42 = Eigen::Matrix<S, 4, 2>;

template <class S>
[[nodiscard]] Matrix2<S> matrix(const S& a11, const S& a12, const S& a21, const S& a22) {
  Matrix2<S> m;
  m(0, 0) = a11;
  m(0, 1) = a12;
  m(1, 0) = a21;
  m(1, 1) = a22;
  return m;
}

template <class S>
[[nodiscard]] Matrix2<S> diagonal(const S& a, const S& b) {
  return matrix<S>(a, S(0), S(0), b);
}

template <class S>
[[nodiscard]] Matrix2<S> identity2() {
  return diagonal<S>(S(1), S(1));
}

// The 2×2 inverse by cofactors: no pivoting, which would need an order. Assumes a nonzero determinant.
template <class S>
[[nodiscard]] Matrix2<S> inverse(const Matrix2<S>& m) {
  const S det = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  return matrix<S>(S(m(1, 1) / det), S(-m(0, 1) / det), S(-m(1, 0) / det), S(m(0, 0) / det));
}

// [[a, b], [c, d]] in 2×2 blocks.
template <class S>
[[nodiscard]] Matrix4<S> blocks(const Matrix2<S>& a, const Matrix2<S>& b, const Matrix2<S>& c,
                                const Matrix2<S>& d) {
  Matrix4<S> m;
  m.template block<2, 2>(0, 0) = a;
  m.template block<2, 2>(0, 2) = b;
  m.template block<2, 2>(2, 0) = c;
  m.template block<2, 2>(2, 2) = d;
  return m;
}

// (a, b)ᵀ with a above b.
template <class S>
[[nodiscard]] Vector4<S> stack(const Vector2<S>& a, const Vector2<S>& b) {
  Vector4<S> v;
  v.template head<2>() = a;
  v.template tail<2>() = b;
  return v;
}

}  // namespace stickslip::model
