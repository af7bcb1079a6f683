// All branches of a family over the interval: followed from orbits at single values, until the strip holds no
// closed motion besides (families/strip.hpp), or parts of it that are left open.
#pragma once

#include <array>
#include <vector>

#include "numeric/branches/branches.hpp"
#include "numeric/branches/curve.hpp"
#include "numeric/branches/tubes.hpp"

namespace stickslip::numeric::branches {

// A branch that was followed from a motion both ways.
struct Followed {
  Point start;
  std::vector<Cell> cells;
  BranchEnd first, last;
  std::array<Point, 2> ends;
  bool closed;
  Tubes tubes;
};

// One system of closing conditions of the family, and the branches found on it.
struct Sheet {
  int system = 0;
  Curve curve;
  std::vector<Followed> branches;
};

struct AllFollowed {
  std::vector<Sheet> sheets;
  std::vector<UnresolvedPart> unresolved;  // where there may be orbits that are on no branch
  bool complete = false;                   // and else there are none
  long cells = 0;                          // that were examined for them
};

// With question.at, the branches of the orbits at that value only.
[[nodiscard]] AllFollowed follow_all(const BranchQuestion& question);

}  // namespace stickslip::numeric::branches
