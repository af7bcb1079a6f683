// A machine in SI units and the dimensionless data that are taken for it, for readers and for programs.
#pragma once

#include <string>

#include "numeric/machine.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// The machine, the data taken, how exact they are, and what the units of the answer are in SI.
[[nodiscard]] std::string terminal_report(const numeric::DataTaken& taken, const tools::Style& style);

// {"si": {"m1", "m2", "k1", "k2", "friction_sliding", "friction_at_rest", "belt_velocity", "load_amplitude",
// "load_frequency", "load_phase"}, "units": {"length", "time", "velocity", "force", "frequency"}: BALL each,
// "rounded": ["omega", "V"]}. Friction is in N; friction_at_rest is absent where it is a result.
[[nodiscard]] tools::Json to_json(const numeric::DataTaken& taken);

}  // namespace stickslip::report::orbits
