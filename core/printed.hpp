// A printed decimal against a proved ball. A printed value stands for the interval of half a unit in its last
// place.
#pragma once

#include <string>

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "core/verdict.hpp"

namespace stickslip {

struct PrintedComparison {
  std::string name;  // the paper's symbol in plain text: "tau"
  Decimal printed;
  Ball value;  // contains the exact value
  // (exact - printed) in units of the last printed place: correctly rounded means at most 1/2 in size.
  Ball units;
  // Of "the printed digits are the exact value, correctly rounded": proved when the ball lies in the
  // interval, refuted when it is disjoint from it, undecided when it straddles an end.
  Verdict verdict;
};

[[nodiscard]] PrintedComparison compare_printed(std::string name, const Decimal& printed, const Ball& value);

// The interval that the printed value stands for.
[[nodiscard]] Ball printed_interval(const Decimal& printed);

}  // namespace stickslip
