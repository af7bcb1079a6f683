#include "core/printed.hpp"

#include <fmt/format.h>

namespace stickslip {

Ball printed_interval(const Decimal& printed) {
  return Ball::from_interval(printed.lower(), printed.upper());
}

PrintedComparison compare_printed(const Decimal& printed, const Ball& value) {
  const Ball units = (value - Ball(printed.value)) / Ball(printed.unit);
  const Ball excess = abs(units) - Ball(Rational(1, 2));
  Verdict verdict = Verdict::undecided(
      fmt::format("the enclosure {} reaches across an end of the printed interval", to_string(value)));
  if (excess.is_negative()) {
    verdict = Verdict::proved();
  } else if (excess.is_positive()) {
    verdict = Verdict::refuted(fmt::format("{} is printed as {}: off by {} units in the last place",
                                           to_string(value), printed.text, to_string(units, 4)));
  }
  return {units, std::move(verdict)};
}

}  // namespace stickslip
