// Proved neighbourhoods of stable orbits of machines: sets of starts whose motions all converge to the orbit.
//
// The set is {c + S z : |z| <= rho}, Euclid's norm, of states (x, x') on one piece of the motion: with a load
// at one phase of it, in the middle of the orbit's longest slide; without, where a slide ends, with x_j'
// given by that event. S is such that the derivative of the return map at c contracts. It is shown that every
// start of a somewhat larger ball comes back to the same section, and that the derivative by z there is
// smaller than 1 in Euclid's norm of z: over the ball at once, or over each of many boxes that cover it; the
// map is continuous, so on any way in the ball, which is convex, distances shrink. The orbit's own point lies
// at c but for less than 1/1000 of rho, so distances from it shrink from one return to the next, and no
// motion leaves the ball around it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "numeric/machines/basins/set_of_motions.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::machines {

struct Neighbourhood {
  Verdict verdict;  // proved, or why there is none
  // Where the starts lie: on `piece`; with a load at `time`, exact, the load's phase being 0 at t = 0, and
  // there theta, 0 <= theta < 2 pi; without, where the piece begins after `before`.
  Piece piece;
  std::optional<Piece> before;
  double time = 0, theta = 0;
  double period = 0;            // from one return to the next, roughly
  Vector centre;                // c, exact
  Matrix S, inverse;            // z = inverse ((x, x') - c); without a load z does not tell of x_j'
  double radius = 0;            // rho
  Eigen::VectorXd half_widths;  // of the set, in each of (x, x')
  Eigen::VectorXd alone;        // how far each may be from c while the others are as there
  long boxes = 1;               // that cover the ball

  // Whether all motions of a set that is where the starts lie are among them.
  [[nodiscard]] bool holds(const SetOfMotions& set) const;
};

// Whether |A| < 1 in Euclid's norm, proved for all members.
[[nodiscard]] bool contracts(const Matrix& A);

// As large as the derivative stays smaller than 1, with boxes whose motions go through at most so many phases
// together (fewer where more than 64 bits are needed). Undecided when nothing is found, and when the orbit is
// not proved to be admissible and stable.
[[nodiscard]] Neighbourhood neighbourhood_of(const Machine& machine, const MachineOrbit& orbit,
                                             long most_phases = 12000);
// Of an orbit of the paper's oscillator over so many periods of the load; undecided, too, where that of the
// same machine in tables is not where the orbit is.
[[nodiscard]] Neighbourhood neighbourhood_of(const words::WordQuestion& machine, const families::Orbit& orbit,
                                             long periods = 1, long most_phases = 12000);

// Sets it of an orbit that is stable.
void surround(families::Orbit& orbit, const words::WordQuestion& machine, long periods = 1);

// Which of some of them motions are proved to reach (reaching.cpp).

// Pixels of a plane: `starts` are their middles, row by row, at load phase 0; in two of the coordinates they
// are so wide to each side.
struct Pixels {
  std::vector<Eigen::VectorXd> starts;
  std::array<int, 2> across;
  std::array<double, 2> half;
  std::array<long, 2> count;  // columns and rows
};
// Which neighbourhood all motions from each pixel reach, as far as that is proved: of some pixels together
// where that succeeds, else of the halves.
[[nodiscard]] std::vector<std::optional<std::size_t>> reached(
    const Machine& machine, const Pixels& pixels, std::vector<std::shared_ptr<const Neighbourhood>> all);

}  // namespace stickslip::numeric::machines
