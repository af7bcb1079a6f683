// From the parts of a branch to its pieces, on which nothing changes, and to the changes between them.
#pragma once

#include "numeric/branches/changes.hpp"

namespace stickslip::numeric::branches {

// Fills in pieces, changes and ends: `first` and `last` as the path has them, replaced where the branch ends
// by a birth before. What is neither decided nor a change goes to `unresolved`.
void describe(const Traced& traced, Branch& branch, std::vector<UnresolvedPart>& unresolved);

// Between neighbouring values at which a piece or an unresolved part begins or ends, where nothing changes;
// not where a branch may turn. Where all branches are looked for, `open` are the parts in which there may be
// orbits on none.
[[nodiscard]] std::vector<Count> counts_of(const BranchQuestion& question,
                                           const std::vector<Branch>& branches,
                                           const std::vector<UnresolvedPart>& open);

}  // namespace stickslip::numeric::branches
