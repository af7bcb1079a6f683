// Manual pages and completion, from the definition of the command line itself.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stickslip::cli {

struct ManualFile {
  std::string name;  // "stickslip-orbits.1"
  std::string text;
};

// A page of section 1 for the program and for each of its commands, and what bash completes:
// stickslip.bash. Options that the help does not show are left out.
[[nodiscard]] std::vector<ManualFile> manual(const CLI::App& program);

}  // namespace stickslip::cli
