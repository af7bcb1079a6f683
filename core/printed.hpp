// A printed decimal against a proved ball. A printed value stands for the interval of half a unit in its last
// place.
#pragma once

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "core/verdict.hpp"

namespace stickslip {

// Of a value that the ball contains.
struct PrintedComparison {
  // (exact - printed) in units of the last printed place: correctly rounded means at most 1/2 in size.
  Ball units;
  // Of "the printed digits are the exact value, correctly rounded": proved when the ball lies in the
  // interval, refuted when it is disjoint from it, undecided when it straddles an end.
  Verdict verdict;
};

[[nodiscard]] PrintedComparison compare_printed(const Decimal& printed, const Ball& value);

// The interval that the printed value stands for.
[[nodiscard]] Ball printed_interval(const Decimal& printed);

}  // namespace stickslip
