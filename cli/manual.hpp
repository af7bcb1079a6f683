// Manual pages and completion, from the definition of the command line itself.
#pragma once

#include <map>
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

// What may stand in a place, "FAMILY", or behind an option, "--example".
using Completions = std::map<std::string, std::vector<std::string>>;

// A page of section 1 for the program and for each of its commands, and what bash completes:
// stickslip.bash, with these words beside commands, options and files. Options that the help does not show
// are left out.
[[nodiscard]] std::vector<ManualFile> manual(const CLI::App& program, const Completions& completions);

}  // namespace stickslip::cli
