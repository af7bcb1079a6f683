#include "cli/typed_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "core/error.hpp"

namespace stickslip::cli {
namespace {

template <class Names>
bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

TypedParameters parse_parameters(const std::string& text, const std::string& file) {
  std::istringstream stream(text);
  TypedParameters parameters;
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(stream)) {
    if (!item.parents.empty()) {
      throw UsageError(fmt::format("{}: '{}' stands in a section, but parameters stand in none", file,
                                   fmt::join(item.parents, ".")));
    }
    if (!has(parameter_names, item.name) && !has(names_in_SI, item.name)) {
      throw UsageError(fmt::format("{}: '{}' is not a parameter: these are {}; or, in SI units, {}", file,
                                   item.name, fmt::join(parameter_names, ", "),
                                   fmt::join(names_in_SI, ", ")));
    }
    if (!parameters.empty() && has(names_in_SI, item.name) != are_in_SI(parameters)) {
      throw UsageError(fmt::format("{}: {} and {} do not go together, for one is in SI units and one is not",
                                   file, parameters.begin()->first, item.name));
    }
    if (item.inputs.size() != 1 || parameters.contains(item.name)) {
      throw UsageError(fmt::format("{}: {} needs exactly one value", file, item.name));
    }
    parameters[item.name] = item.inputs.front();
  }
  return parameters;
}

bool are_in_SI(const TypedParameters& parameters) {
  return !parameters.empty() && has(names_in_SI, parameters.begin()->first);
}

}  // namespace stickslip::cli
