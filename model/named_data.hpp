// The dimensionless data by their names in ASCII, in the paper's order.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/parameters.hpp"

namespace stickslip::model {

template <class S>
inline constexpr std::array<std::pair<const char *, S Parameters<S>::*>, 6> named_data{
    {{"chi", &Parameters<S>::chi},
     {"eta", &Parameters<S>::eta},
     {"us", &Parameters<S>::us},
     {"V", &Parameters<S>::V},
     {"omega", &Parameters<S>::omega},
     {"p", &Parameters<S>::p}}};

template <class S>
[[nodiscard]] std::vector<std::pair<std::string, S>> with_names(const Parameters<S>& data) {
  std::vector<std::pair<std::string, S>> named;
  for (const auto& [name, member] : named_data<S>) {
    named.emplace_back(name, data.*member);
  }
  return named;
}

// Each made from its name.
template <class Make>
[[nodiscard]] auto data_by_name(const Make& make) {
  Parameters<decltype(make("chi"))> data;
  for (const auto& [name, member] : named_data<decltype(make("chi"))>) {
    data.*member = make(name);
  }
  return data;
}

}  // namespace stickslip::model
