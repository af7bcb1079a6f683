// Where a branch leaves for infinity.
//
// The friction law is homogeneous: a motion whose lengths, with us, V, p and ur, are all multiplied by e > 0
// obeys it as before, and the closing conditions are multiplied by e. In units in which one length of a large
// motion has the size 1, and e takes its place among the unknowns, they are finite at e = 0, where us, V and
// p vanish. Lengths that stay bounded are left as they are, and so are the conditions that do not depend on
// the growing ones, or these would vanish with e. Where all are regular at e = 0 the branch goes through
// there in these coordinates, and the motion grows beyond all bounds as e falls to 0.
#pragma once

#include "numeric/branches/curve.hpp"

namespace stickslip::numeric::branches {

// From a proved motion on: cells in which e falls to 0, the last of them to 0 itself, and the limit of the
// free parameter there.
struct WayToInfinity {
  std::vector<Cell> cells;
  Ball limit;
};

// If the branch goes on from the proved motion so that one of its lengths grows without an end, all phases
// lasting: then there is one motion for each size of this length. Nothing where that is not proved, or where
// that length may not grow along the cell, whose last motion it is.
[[nodiscard]] std::optional<WayToInfinity> way_to_infinity(const Curve& curve, const Cell& cell,
                                                           const Point& large);

}  // namespace stickslip::numeric::branches
