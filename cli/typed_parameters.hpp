// Parameters as the user types them, on the command line or in a file.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "model/machine_values.hpp"

namespace stickslip::cli {

inline constexpr std::array parameter_names{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};

// Of a machine in SI units; friction_at_rest and friction_sliding are multiples of normal_force.
inline constexpr auto names_in_SI = [] {
  std::array<const char *, model::machine_values.size()> names{};
  std::ranges::transform(model::machine_values, names.begin(), &model::MachineValue::name);
  return names;
}();

// Texts under the parameters' names.
using TypedParameters = std::map<std::string, std::string>;

// A file of parameters; or, in Python, a machine in SI units that stands in none: its values, and what
// sentences call it. Nothing if the name is empty.
struct GivenFile {
  std::string name;
  std::optional<TypedParameters> values;

  GivenFile(std::string file = {}) : name(std::move(file)) {}  // NOLINT: as it is typed
  [[nodiscard]] bool empty() const { return name.empty(); }
};

// The parameters in TOML, lines such as chi = 0.5; each value is taken as text, exactly. They are either
// dimensionless or those of a machine in SI units. Throws UsageError naming the file and what is not a
// parameter; of what the model lacks, such as damping, that it has none. A byte order mark says nothing.
[[nodiscard]] TypedParameters parse_parameters(const std::string& text, const std::string& file);

[[nodiscard]] bool is_parameter(const std::string& name);
[[nodiscard]] bool is_in_SI(const std::string& name);

// Whether they are those of a machine in SI units.
[[nodiscard]] bool are_in_SI(const TypedParameters& parameters);

}  // namespace stickslip::cli
