// The command line, an argument a line: each is understood or refused, and nothing is run.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "core/error.hpp"

using namespace stickslip;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size) {
  std::istringstream lines(std::string(reinterpret_cast<const char *>(data), size));
  std::vector<std::string> arguments{"stickslip"};
  for (std::string line; std::getline(lines, line);) {
    arguments.push_back(line.c_str());  // up to a null character, as the system hands it over
  }
  std::vector<const char *> argv;
  for (const std::string& argument : arguments) {
    argv.push_back(argument.c_str());
  }
  try {
    (void)cli::parse(static_cast<int>(argv.size()), argv.data(), {});
  } catch (const UsageError&) {
  }
  return 0;
}
