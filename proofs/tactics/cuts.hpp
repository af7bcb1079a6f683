// Where to cut the range of a variable, so that an inequality can be proved on each part.
#pragma once

#include <optional>
#include <vector>

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

struct Cuts {
  std::vector<Rational> places = {};   // in ascending order
  bool has_valley = false;             // f sinks and rises again inside
  std::optional<Rational> below = {};  // where f seems to be negative: then there is nothing else
};

// For 0 ≤ f, of this variable alone, from lower to upper, or far out where there is none: where f is zero
// inside; beside the ends of such a part at which it is zero, and far out, if it has a valley there or no
// end far out. A proposal of floating point; no places where it swings on and on far out.
[[nodiscard]] Cuts cuts(const Term& f, const kernel::Variable& x, const std::optional<Rational>& lower,
                        const std::optional<Rational>& upper);

// df/dx.
[[nodiscard]] Term rate(const Term& f, const kernel::Variable& x);

}  // namespace stickslip::proofs::tactics
