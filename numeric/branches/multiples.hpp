// Where a multiple of the load's frequency is a natural frequency, k omega = omega_j with k > 1, the closing
// conditions of orbits that never stick are singular (families/nonsticking.hpp), and beside it orbits crowd
// or grow without an end: no search comes through there, and none is made near it.
#pragma once

#include <string>
#include <vector>

#include "numeric/branches/branches.hpp"

namespace stickslip::numeric::branches {

struct Multiple {
  std::string name;   // "2 omega = omega1"
  Rational from, to;  // of the parameter: all values at which k omega is within 7.6e-6 of omega_j, relatively
  // Contains a value at which they are equal; nothing where that is not proved, as where the interval ends.
  std::optional<Ball> at;
};

// Those of the question's interval, in order and apart; none for families and words that go on there, or
// where they fill the interval or are too many.
[[nodiscard]] std::vector<Multiple> multiples_in(const BranchQuestion& question);

// What is said of it.
[[nodiscard]] UnresolvedPart left_out(const Multiple& multiple, const std::string& parameter);

}  // namespace stickslip::numeric::branches
