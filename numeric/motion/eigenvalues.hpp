// Rigorous eigenvalues of small real matrices.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/ball.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::motion {

struct ComplexBall {
  Ball re, im;

  [[nodiscard]] Ball squared_modulus() const { return re * re + im * im; }
};

using SquareMatrix = Eigen::Matrix<Ball, Eigen::Dynamic, Eigen::Dynamic>;

// Enclosures of all eigenvalues with their multiplicities, for every member of the matrix: each member has as
// many eigenvalues in a group of overlapping enclosures as the group has members. An enclosure that is
// isolated and meets the real axis holds a real eigenvalue; its imaginary part is exactly 0. By falling
// approximate modulus, complex pairs with the positive imaginary part first. Nothing when Arb finds no
// enclosures: the matrix is too wide, not finite, or (nearly) not diagonalisable.
[[nodiscard]] std::optional<std::vector<ComplexBall>> eigenvalues(const SquareMatrix& matrix);

}  // namespace stickslip::numeric::motion
