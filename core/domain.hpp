// What callers must not go beyond.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip {

// Throws DomainError unless it holds; the value is a number, or says in words what there is.
template <class Value>
void require(bool holds, std::string_view name, const Value& value, std::string_view range) {
  if (holds) {
    return;
  }
  if constexpr (std::is_same_v<Value, Rational>) {
    throw DomainError(std::string(name), to_string(value), std::string(range));
  } else {
    throw DomainError(std::string(name), fmt::format("{}", value), std::string(range));
  }
}

}  // namespace stickslip
