// JSON for programs: what every published result shares.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace stickslip::report::tools {

using Json = nlohmann::ordered_json;

// Version of the layouts of all JSON, which its schemas describe (schemas.hpp): a new number in front
// when something is renamed or removed, behind when added.
inline constexpr const char * schema_version = "2.12";

// What every result says about its origin: {"schema_version", "date": text or null, "program": {"name",
// "version"}, "libraries": [{"name", "version"}], "command"}.
[[nodiscard]] Json provenance(const std::string& command);

// As it stands in a file: indented, ending with a line feed.
[[nodiscard]] std::string to_text(const Json& json);

// The function applied to all members of a container, as a list.
template <class Range, class Function>
[[nodiscard]] Json list_of(const Range& range, const Function& function) {
  Json list = Json::array();
  for (const auto& member : range) {
    list.push_back(function(member));
  }
  return list;
}

}  // namespace stickslip::report::tools
