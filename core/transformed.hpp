// What a function makes of each of several.
#pragma once

#include <iterator>
#include <type_traits>
#include <vector>

namespace stickslip {

// f of each, in their order.
template <class Range, class F>
[[nodiscard]] auto transformed(const Range& range, const F& f) {
  std::vector<std::decay_t<decltype(f(*std::begin(range)))>> result;
  for (const auto& one : range) {
    result.push_back(f(one));
  }
  return result;
}

}  // namespace stickslip
