// Proved neighbourhoods of stable orbits of machines: sets of starts whose motions all converge to the orbit.
//
// The set is {c + S z : |z| <= rho}, Euclid's norm, of states (x, x') on one piece of the motion: with a load
// at one phase of it, in the middle of the orbit's longest slide; without, where a slide ends, with x_j'
// given by that event. S is such that the derivative of the return map at c contracts. It is shown that every
// start of a somewhat larger ball comes back to the same section, and that the derivative by z there is
// smaller than 1 in the norm of S: over the ball at once, or over each of many boxes that cover it; the map
// is continuous, so on any way in the ball, which is convex, distances shrink. The orbit's own point lies at
// c but for less than 1/1000 of rho, so distances from it shrink from one return to the next, and no motion
// leaves the ball around it.
#pragma once

#include "numeric/machines/machine_orbit.hpp"
#include "numeric/machines/set_of_motions.hpp"

namespace stickslip::numeric::machines {

struct Neighbourhood {
  Verdict verdict;  // proved, or why there is none
  // Where the starts lie: on `piece`; with a load at this phase of it, 0 <= theta < 2 pi, and at `time` from
  // the beginning of the orbit's first phase; without, where the piece begins after `before`.
  double theta = 0, time = 0;
  std::optional<Piece> before;
  Piece piece;
  Vector centre;                // (x, x'), exact
  Matrix S, inverse;            // of z from (x, x') - c; without a load x_j' is no part of either
  double radius = 0;            // rho
  Eigen::VectorXd half_widths;  // of the set, in each of (x, x')
  Eigen::VectorXd alone;        // how far each may be from c while the others are as there
  long boxes = 1;               // that cover the ball
};

// As large as the derivative stays smaller than 1, with boxes whose motions go through at most so many phases
// together (fewer where more than 64 bits are needed). Undecided when nothing is found, and when the orbit is
// not proved to be admissible and stable.
[[nodiscard]] Neighbourhood neighbourhood_of(const Machine& machine, const MachineOrbit& orbit,
                                             long most_phases = 12000);

}  // namespace stickslip::numeric::machines
