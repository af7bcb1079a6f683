#include "cli/typed_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::cli {
namespace {

constexpr const char * no_damping =
    "the model has no damping: dry friction alone takes energy; for a machine with dashpots write tables, as "
    "doc/any_machine.md says";
constexpr const char * one_load = "the load of the model is a single harmonic, with one frequency";

// What users look for and the model does not have, by a part of the name that they give it.
constexpr std::pair<const char *, const char *> lacking[] = {
    {"damp", no_damping},
    {"viscous", no_damping},
    {"stribeck", "the model has none: sliding friction is the same at all velocities, as Coulomb says"},
    {"frequency", one_load},
    {"amplitude", one_load},
    {"omega", one_load},
    {"load", one_load}};

[[noreturn]] void not_a_parameter(const std::string& name, const std::string& file) {
  const std::string small = CLI::detail::to_lower(name);
  for (const auto& [part, sentence] : lacking) {
    if (small.find(part) != std::string::npos) {
      throw UsageError(fmt::format("{}: '{}' is not a parameter: {}", file, name, sentence));
    }
  }
  throw UsageError(fmt::format("{}: '{}' is not a parameter: these are {}; or, in SI units, {}", file, name,
                               fmt::join(parameter_names, ", "), fmt::join(names_in_SI, ", ")));
}

// 12,4 and 12.4 kg arrive as two values.
[[noreturn]] void not_one_value(const CLI::ConfigItem& item, const std::string& file) {
  if (item.inputs.size() == 2) {
    const std::string& second = item.inputs.back();
    const bool digits = second.find_first_not_of("0123456789") == std::string::npos;
    if (digits || std::isalpha(static_cast<unsigned char>(second.front())) != 0) {
      (void)parse_range(fmt::format("{}: {}", file, item.name),
                        fmt::format("{}", fmt::join(item.inputs, digits ? "," : " ")));
    }
  }
  const bool of_load = item.name.starts_with("load") || item.name == "omega" || item.name == "p";
  throw UsageError(fmt::format("{}: {} needs exactly one value{}{}", file, item.name, of_load ? ": " : "",
                               of_load ? one_load : ""));
}

// Without the mark that some editors put before UTF-8.
std::string without_mark(const std::string& text, const std::string& file) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw UsageError(fmt::format("{} is in UTF-16: save it as UTF-8", file));
  }
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace

TypedParameters parse_parameters(const std::string& text, const std::string& file) {
  std::istringstream stream(without_mark(text, file));
  TypedParameters parameters;
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(stream)) {
    if (!item.parents.empty()) {
      throw UsageError(fmt::format("{}: '{}' stands in a section, but parameters stand in none", file,
                                   fmt::join(item.parents, ".")));
    }
    if (!is_parameter(item.name) && !is_in_SI(item.name)) {
      not_a_parameter(item.name, file);
    }
    if (!parameters.empty() && is_in_SI(item.name) != are_in_SI(parameters)) {
      throw UsageError(fmt::format("{}: {} and {} do not go together, for one is in SI units and one is not",
                                   file, parameters.begin()->first, item.name));
    }
    if (parameters.contains(item.name)) {
      throw UsageError(fmt::format("{}: {} is given twice: it needs exactly one value", file, item.name));
    }
    if (item.inputs.size() != 1) {
      not_one_value(item, file);
    }
    parameters[item.name] = item.inputs.front();
  }
  return parameters;
}

bool is_parameter(const std::string& name) {
  return std::ranges::find(parameter_names, name) != parameter_names.end();
}

bool is_in_SI(const std::string& name) {
  return model::machine_value(name) != nullptr;
}

bool are_in_SI(const TypedParameters& parameters) {
  return !parameters.empty() && is_in_SI(parameters.begin()->first);
}

}  // namespace stickslip::cli
