// From what the user types to the question that numeric/orbits.hpp answers.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "numeric/orbits.hpp"

namespace stickslip::cli {

// Parameters as text under their names: chi, eta, us, V, omega, p, phi, ur.
using TypedParameters = std::map<std::string, std::string>;

// Options --chi, --eta, … for all of them; each writes the text that it is given.
void add_parameters(CLI::App& command, TypedParameters& parameters);

// A number as core/decimal.hpp reads it, or an interval "0.5+-1e-4" ("0.5±1e-4"). Throws UsageError naming
// the parameter and the text.
[[nodiscard]] Range parse_range(const std::string& name, const std::string& text);

// The family of that name. Throws UsageError naming the known ones.
[[nodiscard]] Family family_named(const std::string& name);

// The parameters in a TOML file of lines such as chi = 0.5; each value is taken as text, exactly. Throws
// InputOutputError when the file cannot be read, UsageError naming what is not a parameter.
[[nodiscard]] TypedParameters read_parameters(const std::string& file);

// The question about the family. `typed` replaces what the file says, which replaces the data of the example;
// file and example may be empty. The example's phi or ur counts only for its own family and when neither is
// given otherwise. Throws UsageError for a missing or malformed parameter.
[[nodiscard]] OrbitQuestion question(Family family, const TypedParameters& typed, const std::string& file,
                                     const std::string& example, int digits);

}  // namespace stickslip::cli
