// The flow of a linear system whose matrix goes from one to another, for all that lie between.
#pragma once

#include <array>

#include "core/ball.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/machines/in_datum.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

// exp((B0 + s B1) t) = E[0] + s E[1] + s² E[2] + R(s), with S R S⁻¹ at most `rest` in the norm of row sums
// for all complex |s| <= 2. R has a zero of third order at s = 0; so its entries are at most an eighth of
// that times |s|³ (Schwarz), and for |s| <= 1 their derivatives by s at most that (Cauchy).
struct FlowsBetween {
  std::array<model::MatrixX<Ball>, 3> E;
  Ball rest;                   // not finite where it could not be bounded
  model::VectorX<Ball> units;  // S, diagonal
  Eigen::MatrixXi pattern;     // 0 where an entry is zero for all s and t

  // For all real |s| <= 1.
  [[nodiscard]] InDatum<model::MatrixX<Ball>> in_datum() const;
  [[nodiscard]] model::MatrixX<Ball> by_s() const;
};

// For all members of t; narrow where t is. S has any positive numbers: with those in which rows and columns
// are of one size the rest is small.
[[nodiscard]] FlowsBetween flows_between(const model::MatrixX<Ball>& B0, const model::MatrixX<Ball>& B1,
                                         const Ball& t, const model::VectorX<Ball>& S);

}  // namespace stickslip::numeric::machines
