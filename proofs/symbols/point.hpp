// Statements at a point: what every symbol of the paper is worth once parameters and times have rational
// values.
#pragma once

#include <vector>

#include "core/verdict.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::symbols {

// The scalars at a point, in balls through model/'s own formulas. The point gives omega1 and omega2 or chi
// and eta, from which the other pair and lambda1, lambda2 follow by (39); d01, d02 follow by (6) and q1, q2
// by (7) unless given. Throws InternalError for a symbol that neither is given nor follows. Precision: the
// working one at the time of the look-up.
[[nodiscard]] Lookup<Ball> at_point(const std::vector<Coordinate>& point);

}  // namespace stickslip::proofs::symbols
