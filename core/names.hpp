// The names of an enumeration's values as a table.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace stickslip {

// The value's name: one is given for each value, in the order of the enumeration, whose last one is `last`.
template <auto last, class... Names>
[[nodiscard]] std::string name_of(decltype(last) value, const Names&... names) {
  constexpr std::size_t count = static_cast<std::size_t>(last) + 1;
  static_assert(sizeof...(names) == count, "each value has a name");
  const std::array<std::string_view, count> all{names...};
  const auto place = static_cast<std::size_t>(value);
  if (place >= count) {
    throw InternalError("a value of an enumeration that has no name");
  }
  return std::string(all[place]);
}

}  // namespace stickslip
