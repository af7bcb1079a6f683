#include "numeric/machines/flows_between.hpp"

#include <cmath>

#include "numeric/machines/linear_phases.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr int most_halvings = 60;

// Which entries a function of B0 + s B1 may have: those that a product of these may.
Eigen::MatrixXi pattern_of(const Matrix& B0, const Matrix& B1) {
  const Eigen::Index n = B0.rows();
  Eigen::MatrixXi may = Eigen::MatrixXi::Identity(n, n);
  for (Eigen::Index i = 0; i < may.size(); ++i) {
    may.data()[i] += is_zero(B0.data()[i]) && is_zero(B1.data()[i]) ? 0 : 1;
  }
  for (Eigen::Index through = 0; through < n; ++through) {
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index i = 0; may(through, k) != 0 && i < n; ++i) {
        may(i, k) = may(i, k) != 0 || may(i, through) != 0 ? 1 : 0;
      }
    }
  }
  return may;
}

// To all matrices with these entries away from it by no more than that in the norm.
void widen(Matrix& A, const FlowsBetween& flows, const Ball& size) {
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index k = 0; k < A.cols(); ++k) {
      if (flows.pattern(i, k) != 0) {
        const Ball most = Ball(size * flows.units(k) / flows.units(i)).upper();
        A(i, k) += Ball::hull(-most, most);
      }
    }
  }
}

Ball size_of(const Matrix& A, const Vector& units) {
  return zeros::norm(Matrix(units.asDiagonal() * A * units.cwiseInverse().asDiagonal())).upper();
}

}  // namespace

InDatum<Matrix> FlowsBetween::in_datum() const {
  Matrix cubic = Matrix::Constant(E[0].rows(), E[0].cols(), Ball(0));
  widen(cubic, *this, rest / Ball(8));
  return {{E[0], E[1], E[2], cubic}};
}

Matrix FlowsBetween::by_s() const {
  Matrix A = E[1] + E[2] * Ball::hull(Ball(-2), Ball(2));
  widen(A, *this, rest);
  return A;
}

// The Taylor polynomial in the time for t/2^k, squared k times as a polynomial in s.
FlowsBetween flows_between(const Matrix& B0, const Matrix& B1, const Ball& t, const Vector& units) {
  const Eigen::Index n = B0.rows();
  FlowsBetween flows{
      {Matrix::Identity(n, n), Matrix::Constant(n, n, Ball(0)), Matrix::Constant(n, n, Ball(0))},
      Ball(0),
      units,
      pattern_of(B0, B1)};
  const Ball first = size_of(B0, flows.units) * abs(t), second = Ball(2) * size_of(B1, flows.units) * abs(t);
  const double whole = Ball(first + second).upper().approximate();
  if (!(whole < std::exp2(most_halvings))) {
    arb_indeterminate(flows.rest.raw());
    return flows;
  }
  const int halvings = whole > 0.5 ? static_cast<int>(std::ceil(std::log2(whole))) + 1 : 0;
  const Ball part(std::exp2(-halvings)), h = t * part;
  // q = |B0 + s B1| h < 1 for |s| <= 2.
  const Ball q = Ball((first + second) * part).upper(), of_s = Ball(second * part).upper();
  Ball power = q;  // q^m/m!
  std::array<Matrix, 3> term = flows.E;
  const double enough = std::exp2(-static_cast<double>(WorkingPrecision::bits()));
  for (long m = 1; m == 1 || power.approximate() > enough; ++m) {
    const Ball step = h / Ball(m);
    for (std::size_t i = 3; i-- > 0;) {
      term[i] = sparse_product(B0, term[i]);
      if (i > 0) {
        term[i] += sparse_product(B1, term[i - 1]);
      }
      term[i] *= step;
      flows.E[i] += term[i];
    }
    power = Ball(power * q / Ball(m + 1)).upper();
  }
  // What is left out of the series in the time; of words with three or more B1 the sum is at most that.
  for (Matrix& A : flows.E) {
    widen(A, flows, Ball(2) * power);
  }
  flows.rest = Ball(of_s * of_s * of_s / Ball(6) * exp(q)).upper();
  for (int k = 0; k < halvings; ++k) {
    std::array<Matrix, 3>& E = flows.E;
    const Ball zeroth = size_of(E[0], flows.units), a = Ball(2) * size_of(E[1], flows.units),
               b = Ball(4) * size_of(E[2], flows.units);
    flows.rest = Ball(flows.rest * (Ball(2) * (zeroth + a + b) + flows.rest) + b * (Ball(2) * a + b)).upper();
    const Matrix squared = zeros::product(E[0], E[0]);
    const Matrix linear = Matrix(zeros::product(E[0], E[1])) + Matrix(zeros::product(E[1], E[0]));
    E[2] = Matrix(zeros::product(E[0], E[2])) + Matrix(zeros::product(E[1], E[1])) +
           Matrix(zeros::product(E[2], E[0]));
    E[1] = linear;
    E[0] = squared;
  }
  return flows;
}

}  // namespace stickslip::numeric::machines
