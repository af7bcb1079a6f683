// Parameters as the user types them, on the command line or in a file.
#pragma once

#include <array>
#include <map>
#include <string>

#include "core/decimal.hpp"

namespace stickslip::cli {

inline constexpr std::array parameter_names{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};

// Texts under the parameters' names.
using TypedParameters = std::map<std::string, std::string>;

// A number as core/decimal.hpp reads it, or an interval "0.5+-1e-4" ("0.5±1e-4"). Throws UsageError naming
// the parameter and the text.
[[nodiscard]] Range parse_range(const std::string& name, const std::string& text);

// The parameters in TOML, lines such as chi = 0.5; each value is taken as text, exactly. Throws UsageError
// naming the file and what is not a parameter.
[[nodiscard]] TypedParameters parse_parameters(const std::string& text, const std::string& file);

}  // namespace stickslip::cli
