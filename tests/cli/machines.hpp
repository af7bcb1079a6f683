// Files of machines in SI units.
#pragma once

#include <fstream>
#include <map>
#include <string>

#include "tests/cli/program.hpp"
#include "tests/report/temporary.hpp"

namespace stickslip {

using Machine = std::map<std::string, std::string>;

// Example O with Omega = 10 and lengths in mm, but for the last digits of omega.
inline const Machine machine_O{{"m1", "4"},
                               {"m2", "1"},
                               {"k1", "320"},
                               {"k2", "80"},
                               {"normal_force", "0.1"},
                               {"friction_at_rest", "1.834"},
                               {"friction_sliding", "0.2"},
                               {"belt_velocity", "0.01"},
                               {"load_amplitude", "0.005"},
                               {"load_frequency", "1.0009254372"}};

[[nodiscard]] inline Machine with(Machine machine, const std::string& name, const std::string& value) {
  machine[name] = value;
  return machine;
}

[[nodiscard]] inline Machine without(Machine machine, const Words& names) {
  for (const std::string& name : names) {
    machine.erase(name);
  }
  return machine;
}

[[nodiscard]] inline Run run_with(const Machine& machine, Words arguments) {
  const TemporaryDirectory temporary;
  const std::string file = temporary.path() / "machine.toml";
  std::ofstream stream(file);
  for (const auto& [name, value] : machine) {
    stream << name << " = " << value << "\n";
  }
  stream.close();
  arguments.insert(arguments.end(), {"--params", file});
  return stickslip_program(arguments);
}

}  // namespace stickslip
