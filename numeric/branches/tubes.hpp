// What the cells of branches leave out: around each arc a tube that holds no other closed motion. Whatever of
// a strip lies in tubes is on a branch.
#pragma once

#include <vector>

#include "numeric/branches/curve.hpp"
#include "numeric/families/strip.hpp"

namespace stickslip::numeric::branches {

class Tubes {
 public:
  Tubes() = default;  // none
  // Of one branch, its cells in order.
  Tubes(const Curve& curve, const std::vector<Cell>& cells);

  // Whether all closed motions with unknowns and parameter within these bounds are on branches: certain, or
  // not known.
  [[nodiscard]] bool hold(const std::vector<families::Bounds>& x, const families::Bounds& parameter) const;
  // The same for unknowns in such units.
  [[nodiscard]] bool hold(const Units& units, const std::vector<families::Bounds>& x,
                          const families::Bounds& parameter) const;

 private:
  struct Tube {
    std::vector<families::Bounds> sides;  // of the unknowns, the driver's place taken by the parameter
    int driver;
    families::Bounds range;  // of the driver
    std::optional<Units> units;
  };
  [[nodiscard]] bool hold_in(const std::optional<Units>& units, const std::vector<families::Bounds>& x,
                             const families::Bounds& parameter) const;

  std::vector<Tube> tubes_;  // along each branch in order
  int angle_ = -1;
};

}  // namespace stickslip::numeric::branches
