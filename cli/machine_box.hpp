// Machines in SI units whose values lie in ranges: a box of data that encloses those of all of them.
#pragma once

#include "cli/machine_file.hpp"
#include "report/atlas/machine.hpp"

namespace stickslip::cli {

struct MachineBox {
  ParameterFile file;  // its parameters A..B where the data vary; its machine is that in the middle
  report::atlas::Machine said;
};

// As read_parameters, of a file whose values, those of a machine in SI units, may be "A..B" or "4+-0.2". Each
// datum of (3) rises or falls with each value, so its least and greatest are at corners of the ranges; what
// is irrational of these is rounded outwards. The unit of length is that power of 1000 m, or the length us,
// in which fewer data vary.
[[nodiscard]] MachineBox read_machine_box(const std::string& file, const TypedParameters& options,
                                          const std::string& example);

}  // namespace stickslip::cli
