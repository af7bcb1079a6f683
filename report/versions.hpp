// What the program was built from: part of every report, so that a result can be had again.
#pragma once

#include <string>
#include <vector>

namespace stickslip::report {

struct Component {
  std::string name;
  std::string version;
};

[[nodiscard]] std::string program_version();

// The libraries that results rest on, as found at run time where they can be asked, in a fixed order.
[[nodiscard]] std::vector<Component> libraries();

}  // namespace stickslip::report
