// Linear programs over the rational numbers.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/rational.hpp"

namespace stickslip::proofs::tactics {

using Column = std::vector<Rational>;

// Numbers x ≥ 0, one for each column, with Σ x_j column_j = right, of which one of those `wanted` is
// positive, if any are. GLPK says in floating point which may be positive, FLINT what they are. Nothing where
// there are none, or where that takes too many steps. All columns are as long as the right side.
[[nodiscard]] std::optional<Column> nonnegative_solution(const std::vector<Column>& columns,
                                                         const Column& right,
                                                         const std::set<std::size_t>& wanted);

}  // namespace stickslip::proofs::tactics
