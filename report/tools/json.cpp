#include "report/tools/json.hpp"

#include "report/tools/versions.hpp"

namespace stickslip::report::tools {

Json provenance(const std::string& command) {
  const auto component = [](const Component& c) -> Json {
    return {{"name", c.name}, {"version", c.version}};
  };
  const std::optional<std::string> date = source_date();
  return {{"schema_version", schema_version},
          {"date", date ? Json(*date) : Json(nullptr)},
          {"program", {{"name", "stickslip"}, {"version", program_version()}}},
          {"libraries", list_of(libraries(), component)},
          {"command", command}};
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stickslip::report::tools
