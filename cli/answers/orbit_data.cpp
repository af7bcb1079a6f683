#include "cli/answers/orbit_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/arguments/arguments.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
#include "proofs/methods/motions.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::motion;
using proofs::methods::Example;
using proofs::methods::Examples;

namespace {

// Those of (2) that every question needs.
const std::vector<std::string> data_names{"chi", "eta", "us", "V", "omega", "p"};

void set(TypedParameters& parameters, const char * name, const std::optional<Rational>& value) {
  if (value) {
    parameters[name] = to_string(*value);
  }
}

TypedParameters parameters_of(const Example& example, const Family& family) {
  TypedParameters parameters;
  for (const auto& [name, datum] : model::named_data<Rational>) {
    parameters[name] = to_string(example.data.*datum);
  }
  if (&family == example.family) {
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

// Of the family: also phi or ur, as far as it is not all that is missing.
void require_data(const TypedParameters& parameters, const Family& family) {
  std::vector<std::string> names = data_names;
  const bool complete = std::all_of(names.begin(), names.end(),
                                    [&](const std::string& name) { return parameters.contains(name); });
  const bool neither = !parameters.contains("phi") && !parameters.contains("ur");
  if (!complete && neither && !family.why_datum.empty()) {
    names.emplace_back(!family.why_no_phi.empty() ? "ur" : !family.why_no_ur.empty() ? "phi" : "phi or --ur");
  }
  require_given(parameters, names);
}

std::optional<Range> optional_range(const TypedParameters& parameters, const std::string& name) {
  const auto found = parameters.find(name);
  return found == parameters.end() ? std::nullopt : std::optional(parse_range(name, found->second));
}

}  // namespace

void require_given(const TypedParameters& parameters, const std::vector<std::string>& names) {
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    if (!parameters.contains(name)) {
      missing.push_back("--" + name);
    }
  }
  if (!missing.empty()) {
    throw UsageError(fmt::format("missing: {}; give {}, or all parameters by --params or --example",
                                 fmt::join(missing, ", "), missing.size() == 1 ? "it" : "them"));
  }
}

TypedParameters given_parameters(const Examples& examples, const ParameterFile& file, const Family * family) {
  TypedParameters all;
  if (!file.example.empty()) {
    const Example& known = example_named(examples, file.example);
    all = parameters_of(known, family == nullptr ? *known.family : *family);
  }
  replace(all, file.parameters);
  replace(all, file.typed);
  return all;
}

OrbitQuestion question(const Examples& examples, const Family& family, const ParameterFile& file,
                       int digits) {
  const TypedParameters all = given_parameters(examples, file, &family);
  require_data(all, family);
  return {&family, model::data_by_name([&](const char * name) { return parse_range(name, all.at(name)); }),
          optional_range(all, "phi"), optional_range(all, "ur"), digits};
}

words::WordQuestion machine(const Examples& examples, const ParameterFile& file, int digits) {
  constexpr int digits_of_ur = 17;
  TypedParameters given = file.parameters;
  replace(given, file.typed);
  if (given.contains("phi")) {
    throw UsageError(
        "phi is not given for a machine: its load is cos(omega t), and where in it an orbit begins is a "
        "result");
  }
  TypedParameters all = given_parameters(examples, file);
  if (!file.example.empty() && !all.contains("ur")) {
    all["ur"] = to_text(printed_orbit(example_named(examples, file.example)).ur(), digits_of_ur).mid;
  }
  std::vector<std::string> names = data_names;
  names.emplace_back("ur");
  require_given(all, names);
  const auto exact = [&](const char * name) { return exact_number(name, all.at(name)); };
  return {model::data_by_name(exact), exact("ur"), digits};
}

NamedOrbit named_orbit(const std::string& name, const proofs::methods::Examples& examples,
                       ParameterFile& file, int digits) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || colon + 1 == name.size()) {
    throw UsageError(
        fmt::format("orbit: '{}' is not FAMILY:K, such as {}:1", name, all_families().front()->name));
  }
  const Family& family = family_named(name.substr(0, colon));
  const auto number =
      static_cast<std::size_t>(whole_number("orbit", name.substr(colon + 1), OrbitsOptions::most_orbits));
  leave_results_out(file, family);
  const OrbitQuestion asked = question(examples, family, file, digits);
  if (asks_for_box(asked)) {
    throw UsageError(fmt::format("the orbit {} needs numbers, but a parameter is an interval", name));
  }
  NamedOrbit found{list_orbits(asked), number - 1};
  const std::size_t count = found.list.orbits.size();
  if (number > count) {
    throw UsageError(fmt::format("there is no orbit {}: {} {} in the list of stickslip orbits {}", name,
                                 count, count == 1 ? "is" : "are", family.name));
  }
  return found;
}

}  // namespace stickslip::cli
