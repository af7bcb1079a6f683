// JSON for programs: what every published result shares.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::report::tools {

using Json = nlohmann::ordered_json;

// Version of the layouts of all JSON, which its schemas describe (schemas.hpp): a new number in front
// when something is renamed or removed, behind when added.
inline constexpr const char * schema_version = "2.14";

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

// What the program was built from: part of every report, so that a result can be had again.

struct Component {
  std::string name;
  std::string version;
};

[[nodiscard]] std::string program_version();

// The moment that SOURCE_DATE_EPOCH names, "2012-11-01T00:00:00Z"; none when it is not set: no output has any
// other date. Throws UsageError when it is not a whole number of seconds.
[[nodiscard]] std::optional<std::string> source_date();

// The libraries that results rest on, as found at run time where they can be asked, in a fixed order.
[[nodiscard]] std::vector<Component> libraries();

}  // namespace stickslip::report::tools
