// What a machine of any number of masses does, for readers.
#pragma once

#include <string>

#include "numeric/machines/machine_attractors.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// The machine in a few lines; a line for each attractor; then each proved orbit with its period, phases,
// multipliers and the least margin of each condition. With units of the SI, or without any.
[[nodiscard]] std::string terminal_report(const numeric::machines::MachineAttractors& list,
                                          const tools::Style& style, bool in_SI);

}  // namespace stickslip::report::orbits
