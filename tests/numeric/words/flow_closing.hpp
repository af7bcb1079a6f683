// Motions that close, by Newton's method from a grid through the flows alone: doubles, and no formula of the
// lists.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numeric/words/complete_list.hpp"

namespace stickslip::numeric::words {

// What is to vanish for these phases, of which the last is a stick. The unknowns are the durations of all but
// the last, z10, z20, z10' and phi.
struct FlowClosing {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;  // four phases at most

  model::Oscillator<double> o;
  double ur, total;
  std::vector<motion::PhaseKind> phases;

  FlowClosing(const WordQuestion& q, const std::vector<motion::PhaseKind>& kinds);

  [[nodiscard]] Vector operator()(const Vector& x) const;
};

// The durations of all phases but the last, of what is found from a grid of so many steps; phases shorter
// than 0.001 say nothing.
[[nodiscard]] std::vector<Eigen::VectorXd> grid_orbits(const FlowClosing& f, int steps);

}  // namespace stickslip::numeric::words
