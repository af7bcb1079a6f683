#include "core/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/decimal.hpp"

namespace stickslip {

std::string plain(std::string sentence) {
  std::erase(sentence, '$');
  return sentence;
}

std::string to_string(Truth truth) {
  switch (truth) {
    case Truth::proved:
      return "proved";
    case Truth::refuted:
      return "refuted";
    case Truth::undecided:
      return "undecided";
    case Truth::assumed:
      return "assumed";
    case Truth::checked:
      return "checked";
  }
  return "undecided";
}

Verdict Verdict::refuted(Witness witness) {
  std::vector<std::string> point;
  for (const Coordinate& coordinate : witness.point) {
    point.push_back(fmt::format("${} = {}$", coordinate.name, to_string(coordinate.value)));
  }
  point.insert(point.end(), witness.values.begin(), witness.values.end());
  std::string reason = fmt::format(
      "{}{} is {} and {} is {}{}",
      witness.component.empty() ? "" : fmt::format("entry {}: ", witness.component), witness.left_name,
      to_string(witness.left, 10), witness.right_name, to_string(witness.right, 10),
      point.empty() ? "" : fmt::format(" at {}", fmt::join(point, ", ")));
  return {Truth::refuted, std::move(reason), std::move(witness)};
}

Verdict all_of(const std::vector<Verdict>& verdicts) {
  for (const Truth truth : {Truth::refuted, Truth::undecided, Truth::checked, Truth::assumed}) {
    const auto found = std::find_if(verdicts.begin(), verdicts.end(),
                                    [truth](const Verdict& verdict) { return verdict.truth == truth; });
    if (found != verdicts.end()) {
      return *found;
    }
  }
  return verdicts.empty() ? Verdict::undecided("nothing was examined") : Verdict::proved();
}

}  // namespace stickslip
