#include "cli/answers/machine_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/answers/machine_tables.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

using numeric::DataTaken;
using numeric::MachineInSI;

namespace {

constexpr const char * friction_forces[] = {"friction_force_sliding", "friction_force_at_rest"};
constexpr const char * coefficients[] = {"normal_force", "friction_sliding", "friction_at_rest"};

bool has_forces(const TypedParameters& parameters) {
  return parameters.contains(friction_forces[0]) || parameters.contains(friction_forces[1]);
}

void require_one_kind_of_friction(const TypedParameters& parameters, const std::string& file) {
  for (const char * name : coefficients) {
    if (has_forces(parameters) && parameters.contains(name)) {
      throw UsageError(fmt::format(
          "{}: {} does not go with a friction force in N: friction is either normal_force with two "
          "coefficients, friction_sliding and friction_at_rest, or friction_force_sliding and "
          "friction_force_at_rest",
          file, name));
    }
  }
}

void require_complete(const TypedParameters& parameters, const std::string& file, FrictionAtRest at_rest) {
  std::vector<std::string> needed{"m1", "m2", "k1", "k2"};
  if (has_forces(parameters)) {
    needed.emplace_back("friction_force_sliding");
  } else {
    needed.insert(needed.end(), {"normal_force", "friction_sliding"});
  }
  if (at_rest == FrictionAtRest::needed) {
    needed.emplace_back(has_forces(parameters) ? "friction_force_at_rest" : "friction_at_rest");
  }
  needed.insert(needed.end(), {"belt_velocity", "load_amplitude", "load_frequency"});
  std::erase_if(needed, [&](const std::string& name) { return parameters.contains(name); });
  if (!needed.empty()) {
    throw UsageError(fmt::format("{}: missing for a machine in SI units: {}", file, fmt::join(needed, ", ")));
  }
}

// Significant digits of a decimal as it is typed: 3 of -0.213e-2; none of a fraction, which is exact.
int significant_digits(const std::string& typed) {
  if (typed.find('/') != std::string::npos) {
    return 0;
  }
  const std::string mantissa = typed.substr(0, typed.find_first_of("eE"));
  const std::size_t first = mantissa.find_first_of("123456789");
  return first == std::string::npos
             ? 0
             : static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first),
                                              mantissa.end(), [](char c) { return c != '.'; }));
}

int deserved_digits(const TypedParameters& parameters) {
  int most = 4;
  for (const auto& [name, typed] : parameters) {
    most = std::max(most, significant_digits(typed));
  }
  return most + 2;
}

}  // namespace

TypedParameters contents_of(const GivenFile& file) {
  if (file.values || file.empty()) {
    return file.values.value_or(TypedParameters());
  }
  const std::string text = report::tools::read_file(file.name);
  if (has_tables(text)) {
    throw UsageError(fmt::format(
        "{} is a machine in tables: that is for stickslip orbits WORD, branch WORD, attractors and simulate, "
        "without other data",
        file.name));
  }
  TypedParameters all = parse_parameters(text, file.name);
  for (const auto& [name, value] : all) {
    (void)interval(fmt::format("{}: {}", file.name, name), value);  // throws where it is none, nor a number
  }
  return all;
}

MachineInSI machine_in_SI(const TypedParameters& parameters, const std::string& file,
                          FrictionAtRest at_rest) {
  require_one_kind_of_friction(parameters, file);
  require_complete(parameters, file, at_rest);
  const auto value = [&](const std::string& name) {
    const Range range = parse_range(name, parameters.at(name));
    if (range.radius != 0) {
      throw UsageError(fmt::format("{}: '{}' is an interval, but a machine in SI units is given by numbers",
                                   name, parameters.at(name)));
    }
    return range.middle;
  };
  const auto force = [&](const std::string& name) {
    const Rational friction = value(name);
    if (friction <= 0) {
      throw DomainError(name, to_string(friction), name + " > 0");
    }
    return friction;
  };
  const Rational normal = has_forces(parameters) ? Rational(1) : force("normal_force");
  const bool forces = has_forces(parameters);
  const char * const rest = forces ? friction_forces[1] : coefficients[2];
  MachineInSI machine{value("m1"),
                      value("m2"),
                      value("k1"),
                      value("k2"),
                      force(forces ? friction_forces[0] : coefficients[1]) * normal,
                      std::nullopt,
                      value("belt_velocity"),
                      value("load_amplitude"),
                      value("load_frequency")};
  if (parameters.contains(rest)) {
    machine.friction_at_rest = force(rest) * normal;
  }
  if (parameters.contains("load_phase")) {
    machine.load_phase = value("load_phase");
  }
  return machine;
}

ParameterFile read_parameters(const GivenMachine& given, FrictionAtRest at_rest,
                              const std::function<TypedParameters(const TypedParameters&)>& one_of) {
  const std::string& file = given.file.name;
  TypedParameters parameters = contents_of(given.file);
  if (!given.file.values && !are_in_SI(parameters)) {
    for (const auto& [name, text] : given.parameters) {
      if (is_in_SI(name)) {
        throw UsageError(
            fmt::format("{} is a value of a machine in SI units: give its file by --params", name));
      }
    }
    return {given.parameters, given.example, file, parameters, std::nullopt, {}, 0, {}};
  }
  if (!given.example.empty()) {
    throw UsageError(fmt::format("--example does not go with the machine of {}: both give all data", file));
  }
  for (const auto& [name, text] : given.parameters) {
    if (is_in_SI(name)) {
      parameters[name] = text;
    } else if (name != "phi") {
      throw UsageError(fmt::format(
          "--{} does not go with the machine of {}, which is in SI units: change it there", name, file));
    }
  }
  const TypedParameters one = one_of(parameters);
  const DataTaken taken = numeric::data_taken(machine_in_SI(one, file, at_rest));
  TypedParameters dimensionless;
  for (const auto& [name, datum] : model::named_data<Rational>) {
    dimensionless[name] = to_string(taken.data.*datum);
  }
  if (taken.ur) {
    dimensionless["ur"] = to_string(*taken.ur);
  }
  return {given.parameters, given.example, file, dimensionless, taken, parameters, deserved_digits(one), {}};
}

int digits_of(std::optional<int> asked, ParameterFile& file) {
  file.digits = asked.value_or(file.digits);
  return asked.value_or(OrbitsOptions::default_digits);
}

model::Vector4<double> in_data(const std::string& name, const State& state,
                               const report::orbits::Units& units) {
  return units.of_state(model::Vector4<double>(of_two_masses(name, state).data()));
}

Error in_keys_of(const GivenFile& file, const DomainError& error) {
  constexpr std::pair<const char *, const char *> keys[] = {
      {"p", "load_amplitude"}, {"V", "belt_velocity"}, {"omega", "load_frequency"}};
  const std::string_view message = error.what();  // begins with the name of the datum
  if (!file.values && !file.empty() && has_tables(report::tools::read_file(file.name))) {
    return error;
  }
  const TypedParameters parameters = contents_of(file);
  for (const auto& [datum, key] : keys) {
    const auto typed = parameters.find(key);
    if (typed != parameters.end() && message.starts_with(fmt::format("{} = ", datum))) {
      return {error.code(), fmt::format("{} = {} in {}: {}", key, typed->second, file.name, message)};
    }
  }
  return error;
}

numeric::MachineAlong machine_between(const ParameterFile& file, const std::string& name,
                                      const Rational& from, const Rational& to) {
  if (name == "load_phase") {
    throw UsageError("load_phase: no orbit depends on it, for it is where simulations begin");
  }
  const auto at = [&](const Rational& value) {
    TypedParameters there = file.in_SI;
    there[name] = to_string(value);
    MachineInSI machine = machine_in_SI(there, file.name, FrictionAtRest::optional);
    if (!file.machine->machine.friction_at_rest) {
      machine.friction_at_rest.reset();
    }
    return machine;
  };
  return {at(from), at(to), from, to, file.machine->thousands};
}

void leave_out(ParameterFile& file, const std::string& parameter, const std::string& why) {
  const auto found = file.parameters.find(parameter);
  if (found == file.parameters.end()) {
    return;
  }
  (void)parse_range(parameter, found->second);  // nonsense is refused even where it does not matter
  file.parameters.erase(found);
  if (file.machine) {
    file.machine->ur.reset();
    file.machine->machine.friction_at_rest.reset();
  }
  file.left_out.push_back(fmt::format("{}: {} is not taken: {}.", file.name,
                                      file.machine ? "the friction at rest" : parameter, why));
}

void leave_results_out(ParameterFile& file, const numeric::Family& family) {
  if (!family.why_no_phi.empty()) {
    leave_out(file, "phi", family.why_no_phi);
  }
  if (!family.why_no_ur.empty()) {
    leave_out(file, "ur", family.why_no_ur);
  }
  if (family.why_datum.empty()) {
    return;
  }
  const bool by_phi = file.typed.contains("phi");
  if (by_phi && !file.typed.contains("ur")) {
    leave_out(file, "ur", "with --phi it is a result");
  }
  if (!by_phi && (file.typed.contains("ur") || file.parameters.contains("ur"))) {
    leave_out(file, "phi", "with ur it is a result");
  }
}

report::tools::Json with_machine(report::tools::Json json, const ParameterFile& file) {
  if (file.machine) {
    json["machine"] = report::orbits::to_json(*file.machine);
  }
  return json;
}

report::orbits::Units units_of(bool si, const ParameterFile& file, bool json) {
  if (!si) {
    return file.machine ? report::orbits::Units::dimensionless(*file.machine, file.digits)
                        : report::orbits::Units();
  }
  if (!file.machine) {
    throw UsageError("--units si needs a machine in SI units: give its file by --params");
  }
  if (json) {
    throw UsageError("--units si is for text: JSON is in the units that stand in it under machine");
  }
  return report::orbits::Units(*file.machine, file.digits);
}

}  // namespace stickslip::cli
