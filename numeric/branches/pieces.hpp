// From the parts of a branch to its pieces, on which nothing changes, and to the changes between them.
#pragma once

#include "numeric/branches/changes.hpp"

namespace stickslip::numeric::branches {

// Fills in pieces, changes and ends: `first` and `last` as the path has them, replaced where the branch ends
// by a birth before. What is neither decided nor a change goes to `unresolved`.
void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved);

}  // namespace stickslip::numeric::branches
