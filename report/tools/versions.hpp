// What the program was built from: part of every report, so that a result can be had again.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stickslip::report::tools {

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
