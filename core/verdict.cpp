#include "core/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/decimal.hpp"
#include "core/names.hpp"

namespace stickslip {

std::string plain(std::string sentence) {
  std::erase(sentence, '$');
  return sentence;
}

std::string to_string(Truth truth) {
  return name_of<Truth::checked>(truth, "proved", "refuted", "undecided", "assumed", "checked");
}

namespace {

// Ten, and more where these say the same of two numbers that are not.
int digits_for(const Ball& one, const Ball& other) {
  const auto middle = [](const Ball& ball, int digits) {
    std::string text = to_string(ball, digits);
    text = text.substr(0, text.find(' '));
    if (text.find('.') != std::string::npos) {  // 1.000 says the same as 1
      text.erase(text.find_last_not_of('0') + 1);
    }
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
  };
  int digits = 10;
  while (digits < 1000 && !one.overlaps(other) && middle(one, digits) == middle(other, digits)) {
    digits *= 2;
  }
  return digits;
}

}  // namespace

Verdict Verdict::refuted(Witness witness) {
  const auto said = [digits = digits_for(witness.left, witness.right)](const Ball& side) {
    return side.is_finite() ? to_string(side, digits) : "a number that balls do not enclose";
  };
  std::vector<std::string> point;
  for (const Coordinate& coordinate : witness.point) {
    point.push_back(fmt::format("${} = {}$", coordinate.name, to_string(coordinate.value)));
  }
  point.insert(point.end(), witness.values.begin(), witness.values.end());
  std::string reason =
      fmt::format("{}{} is {} and {} is {}{}",
                  witness.component.empty() ? "" : fmt::format("entry {}: ", witness.component),
                  witness.left_name, said(witness.left), witness.right_name, said(witness.right),
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
