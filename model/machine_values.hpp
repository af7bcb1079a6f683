// The values that say a machine in SI units, as its file and options name them.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace stickslip::model {

struct MachineValue {
  const char * name;
  const char * unit;   // empty for a coefficient
  const char * words;  // for a reader
};

inline constexpr std::array machine_values{
    MachineValue{"m1", "kg", "mass between the springs, in kg"},
    MachineValue{"m2", "kg", "mass on the belt, which the load acts on, in kg"},
    MachineValue{"k1", "N/m", "stiffness between mass 1 and the wall, in N/m"},
    MachineValue{"k2", "N/m", "stiffness between the masses, in N/m"},
    MachineValue{"normal_force", "N", "of mass 2 on the belt, in N, with the two coefficients that follow"},
    MachineValue{"friction_sliding", "", "coefficient of sliding friction, > 0"},
    MachineValue{"friction_at_rest", "", "coefficient of friction at rest, greater than that of sliding"},
    MachineValue{"friction_force_sliding", "N",
                 "sliding friction in N, in place of normal_force and a coefficient"},
    MachineValue{"friction_force_at_rest", "N", "greatest friction at rest in N, likewise"},
    MachineValue{"belt_velocity", "m/s", "in m/s"},
    MachineValue{"load_amplitude", "N", "of the force on mass 2, in N"},
    MachineValue{"load_frequency", "Hz", "in Hz"},
    MachineValue{"load_phase", "rad", "of the load at t = 0 in simulations, in rad: 0 if it is left out"}};

// Null if there is none of that name.
[[nodiscard]] constexpr const MachineValue * machine_value(std::string_view name) {
  const auto * const found =
      std::ranges::find_if(machine_values, [&](const MachineValue& value) { return value.name == name; });
  return found == machine_values.end() ? nullptr : &*found;
}

}  // namespace stickslip::model
