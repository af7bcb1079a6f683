// Numbers and parameters as the user types them, on the command line or in a file.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "core/rational.hpp"
#include "model/machine_values.hpp"

namespace stickslip::cli {

// Numbers on the command line. All readers throw UsageError naming `name`.

// From 1 to `most`.
[[nodiscard]] int whole_number(const std::string& name, const std::string& text, int most);

// A number, exactly and in double, and one above zero; an interval is none.
[[nodiscard]] Rational exact_number(const std::string& name, const std::string& text);
[[nodiscard]] double number(const std::string& name, const std::string& text);
[[nodiscard]] double positive(const std::string& name, const std::string& text);

// "A..B" with A < B, "0.5+-1e-4", "4+-5%" or a number: its ends.
[[nodiscard]] std::pair<Rational, Rational> interval(const std::string& name, const std::string& text);

// Positions, then velocities, of "x1,x2,x1',x2'": two for each mass; those of the paper's two masses.
using State = std::vector<double>;
[[nodiscard]] State state(const std::string& name, const std::string& text);
[[nodiscard]] std::array<double, 4> of_two_masses(const std::string& name, const State& state);

// Two of x1, x2, x1', x2', 0 to 3, of "x1,x2".
[[nodiscard]] std::array<int, 2> plane(const std::string& name, const std::string& text, std::size_t masses);

// Of --units: true for "si". Throws UsageError for any other text.
[[nodiscard]] bool is_si(const std::string& text);

// How many threads may search for orbits and prove them: by default all cores.
inline constexpr int most_jobs = 1024;
[[nodiscard]] Jobs jobs(std::optional<int> threads);

// Parameters as the user types them, on the command line or in a file.

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
