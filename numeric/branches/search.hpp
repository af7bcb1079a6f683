// All branches of a family over the interval: followed from orbits at single values, until the strip holds no
// closed motion besides (families/strip.hpp), or parts of it that are left open.
#pragma once

#include <array>
#include <vector>

#include "numeric/branches/branches.hpp"
#include "numeric/branches/curve.hpp"
#include "numeric/families/strip.hpp"

namespace stickslip::numeric::branches {

// What the cells of branches leave out: around each arc a tube that holds no other closed motion. Whatever of
// a strip lies in tubes is on a branch.
class Tubes {
 public:
  Tubes() = default;  // none
  // Of one branch, its cells in order.
  Tubes(const Curve& curve, const std::vector<Cell>& cells);

  // Whether all closed motions with unknowns and parameter within these bounds are on branches: certain, or
  // not known.
  [[nodiscard]] bool hold(const std::vector<families::Bounds>& x, const families::Bounds& parameter) const;
  // The same for unknowns in such units, their angle as it is.
  [[nodiscard]] bool hold(const std::optional<Units>& units, const std::vector<families::Bounds>& x,
                          const families::Bounds& parameter) const;

 private:
  struct Tube {
    std::vector<families::Bounds> sides;  // of the unknowns, the driver's place taken by the parameter
    int driver;
    families::Bounds range;  // of the driver
    std::optional<Units> units;
  };

  std::vector<Tube> tubes_;  // along each branch in order
  int angle_ = -1;
};

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
