// The closing conditions at the values that the paper prints for an orbit.
#pragma once

#include <array>

#include "core/printed.hpp"
#include "model/lift.hpp"
#include "model/symmetric.hpp"
#include "numeric/families/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

// The paper's own four equations (16) as a function of x = (tau, z10, z20, zdot10), for zeros/krawczyk.hpp.
struct Equations16 {
  model::SymmetricData<Ball> data;
  model::Vector2<Ball> Q;  // of the load, its sign turned for the second load phase

  template <class T>
  [[nodiscard]] model::Vector4<T> operator()(const model::Vector4<T>& x) const {
    const model::Vector2<T> z0(x(1), x(2));
    const model::Vector2<T> zdot0(x(3), T(data.V));
    return model::symmetric_residual<T>(T(data.chi), model::lift<T>(data.m), model::lift<T>(Q), T(data.omega),
                                        T(data.Theta), x(0), z0, zdot0);
  }
};

// At the working precision.
[[nodiscard]] Equations16 equations_16(const numeric::motion::ExactParameters& a,
                                       numeric::families::LoadPhase phase);

// What conditions leave at printed decimals.
template <int N>
struct PrintedClosing {
  Eigen::Matrix<Ball, N, 1> at_points;     // at the decimals themselves
  Eigen::Matrix<Ball, N, 1> at_intervals;  // over the intervals that they stand for
  Verdict verdict;  // of "the intervals contain a zero"; undecided at best by evaluation
};

// (16), the paper's load phase, at (tau, z10, z20, zdot10); refuted or proved by Krawczyk's test.
[[nodiscard]] PrintedClosing<4> printed_zero_of_16(const numeric::motion::ExactParameters& a,
                                                   const std::array<Decimal, 4>& printed);

// z2'(tau) - V, then z1, z2, z1', z2' of Z(Theta) - Z0, through the flows (5), (8), (10), at (tau, tau1, z10,
// z20, zdot10); refuted when one of them is zero nowhere in the intervals. Throws DomainError outside the
// domain of orbits that stick.
[[nodiscard]] PrintedClosing<5> printed_closing_overshooting(const numeric::motion::ExactParameters& a,
                                                             const Rational& phi,
                                                             const std::array<Decimal, 5>& printed);

}  // namespace stickslip::proofs::pascal2012
