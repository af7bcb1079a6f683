// From the parts of a branch to its pieces and to the changes between them.
#pragma once

#include "numeric/branches/law.hpp"

namespace stickslip::numeric::branches {

// Everything that a branch's record is made of.
struct Traced {
  const Curve& curve;
  const Law& law;
  const std::vector<Cell>& cells;
  const std::vector<Part>& parts;
};

// Fills in pieces, changes and ends: `first` and `last` as the path has them, replaced where the branch ends
// by a birth before. What is neither decided nor a change goes to `unresolved`.
void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved);

}  // namespace stickslip::numeric::branches
