#include "cli/orbit_data.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <sstream>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/examples.hpp"
#include "report/files.hpp"
#include "report/orbit_words.hpp"

namespace stickslip::cli {
namespace {

constexpr std::array<const char*, 6> required{"chi", "eta", "us", "V", "omega", "p"};
constexpr std::array<const char*, 2> optional{"phi", "ur"};

bool is_parameter(const std::string& name) {
  return std::find(required.begin(), required.end(), name) != required.end() ||
         std::find(optional.begin(), optional.end(), name) != optional.end();
}

Rational parse_named(const std::string& name, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", name, error.what()));
  }
}

void set(TypedParameters& parameters, const char* name, const std::optional<Rational>& value) {
  if (value) {
    parameters[name] = to_string(*value);
  }
}

TypedParameters parameters_of(const Example& example, Family family) {
  const ExactParameters& a = example.data;
  TypedParameters parameters;
  set(parameters, "chi", a.chi);
  set(parameters, "eta", a.eta);
  set(parameters, "us", a.us);
  set(parameters, "V", a.V);
  set(parameters, "omega", a.omega);
  set(parameters, "p", a.p);
  if (family == example.family) {
    set(parameters, "phi", example.phi);
    set(parameters, "ur", example.ur);
  }
  return parameters;
}

// What the new parameters say goes before what the old ones say; phi and ur stand for one choice.
void replace(TypedParameters& old, const TypedParameters& with) {
  if (with.contains("phi") || with.contains("ur")) {
    old.erase("phi");
    old.erase("ur");
  }
  for (const auto& [name, text] : with) {
    old[name] = text;
  }
}

Range required_range(const TypedParameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) {
    throw UsageError(fmt::format(
        "the parameter {0} is missing: give --{0}, or all of them by --params or --example", name));
  }
  return parse_range(name, found->second);
}

std::optional<Range> optional_range(const TypedParameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? std::nullopt : std::optional(parse_range(name, found->second));
}

void add_parameter(CLI::App& command, TypedParameters& parameters, const std::string& name,
                   const std::string& description) {
  command
      .add_option_function<std::string>(
          "--" + name, [&parameters, name](const std::string& text) { parameters[name] = text; }, description)
      ->type_name("NUMBER");
}

}  // namespace

void add_parameters(CLI::App& command, TypedParameters& parameters) {
  add_parameter(command, parameters, "chi", "Stiffness ratio k2/(k1 + k2), 0 < chi < 1");
  add_parameter(command, parameters, "eta", "Mass ratio m1/m2 > 0");
  add_parameter(command, parameters, "us", "Slipping friction force > 0");
  add_parameter(command, parameters, "V", "Belt velocity; > 0 for orbits with a stick phase");
  add_parameter(command, parameters, "omega", "Frequency of the load > 0");
  add_parameter(command, parameters, "p", "Amplitude of the load >= 0");
  add_parameter(command, parameters, "phi", "Phase of the load");
  add_parameter(command, parameters, "ur", "Friction force at rest > us");
}

Range parse_range(const std::string& name, const std::string& text) {
  for (const std::string separator : {"+-", "±"}) {
    const std::size_t place = text.find(separator);
    if (place != std::string::npos) {
      const Range range{parse_named(name, text.substr(0, place)),
                        parse_named(name, text.substr(place + separator.size()))};
      if (range.radius < 0) {
        throw UsageError(fmt::format("{}: '{}' has a negative half width", name, text));
      }
      return range;
    }
  }
  return {parse_named(name, text)};
}

Family family_named(const std::string& name) {
  for (const Family family : {Family::symmetric, Family::overshooting, Family::nonsticking}) {
    if (name == report::name_of(family)) {
      return family;
    }
  }
  throw UsageError(
      fmt::format("there is no family '{}' of orbits: symmetric, overshooting or nonsticking", name));
}

TypedParameters read_parameters(const std::string& file) {
  std::istringstream stream(report::read_file(file));
  TypedParameters parameters;
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(stream)) {
    if (!item.parents.empty()) {
      throw UsageError(fmt::format("{}: '{}' stands in a section, but parameters stand in none", file,
                                   fmt::join(item.parents, ".")));
    }
    if (!is_parameter(item.name)) {
      throw UsageError(fmt::format("{}: '{}' is not a parameter: these are {} and {}", file, item.name,
                                   fmt::join(required, ", "), fmt::join(optional, ", ")));
    }
    if (item.inputs.size() != 1 || parameters.contains(item.name)) {
      throw UsageError(fmt::format("{}: {} needs exactly one value", file, item.name));
    }
    parameters[item.name] = item.inputs.front();
  }
  return parameters;
}

OrbitQuestion question(Family family, const TypedParameters& typed, const std::string& file,
                       const std::string& example, int digits) {
  TypedParameters all;
  if (!example.empty()) {
    all = parameters_of(example_named(example), family);
  }
  if (!file.empty()) {
    replace(all, read_parameters(file));
  }
  replace(all, typed);
  return {family,
          {required_range(all, "chi"), required_range(all, "eta"), required_range(all, "us"),
           required_range(all, "V"), required_range(all, "omega"), required_range(all, "p")},
          optional_range(all, "phi"),
          optional_range(all, "ur"),
          digits};
}

}  // namespace stickslip::cli
