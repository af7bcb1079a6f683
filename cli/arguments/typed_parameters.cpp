#include "cli/arguments/typed_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

int whole_number(const std::string& name, const std::string& text, int most) {
  int value = 0;
  const char * const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < 1 || value > most) {
    throw UsageError(fmt::format("{}: '{}' is not a whole number from 1 to {}", name, text, most));
  }
  return value;
}

Rational exact_number(const std::string& name, const std::string& text) {
  const Range range = parse_range(name, text);
  if (range.radius != 0) {
    throw UsageError(fmt::format("{}: '{}' is an interval, but a number is needed here", name, text));
  }
  return range.middle;
}

std::pair<Rational, Rational> interval(const std::string& name, const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots != std::string::npos) {
    if (dots == 0 || dots + 2 == text.size()) {
      throw UsageError(fmt::format("{}: '{}' is not an interval A..B, such as 0.1..0.5", name, text));
    }
    const std::pair ends{exact_number(name, text.substr(0, dots)), exact_number(name, text.substr(dots + 2))};
    if (ends.first >= ends.second) {
      throw UsageError(fmt::format("{}: '{}' does not rise: A..B needs A < B", name, text));
    }
    return ends;
  }
  const std::size_t sign = text.find("+-");
  if (text.ends_with('%') && sign != std::string::npos) {
    const Rational middle = exact_number(name, text.substr(0, sign));
    const Rational share = exact_number(name, text.substr(sign + 2, text.size() - sign - 3)) / 100;
    const Rational radius = abs(middle * share);
    return {middle - radius, middle + radius};
  }
  const Range range = parse_range(name, text);
  return {range.middle - range.radius, range.middle + range.radius};
}

double number(const std::string& name, const std::string& text) {
  return Ball(exact_number(name, text)).approximate();  // to nearest; GMP's own conversion cuts off
}

double positive(const std::string& name, const std::string& text) {
  const double value = number(name, text);
  if (!(value > 0)) {
    throw UsageError(fmt::format("{}: '{}' is not a positive number", name, text));
  }
  return value;
}

State state(const std::string& name, const std::string& text) {
  State X;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    X.push_back(number(name, text.substr(from, comma - from)));
    from = comma + 1;
  }
  return X;
}

std::array<double, 4> of_two_masses(const std::string& name, const State& state) {
  if (state.size() != 4) {
    throw UsageError(fmt::format("{}: '{}' is not four numbers x1,x2,x1',x2'", name, fmt::join(state, ",")));
  }
  return {state[0], state[1], state[2], state[3]};
}

std::array<int, 2> plane(const std::string& name, const std::string& text, std::size_t masses) {
  std::vector<std::string> names;
  for (const char * kind : {"", "'"}) {
    for (std::size_t i = 1; i <= masses; ++i) {
      names.push_back(fmt::format("x{}{}", i, kind));
    }
  }
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto first = std::ranges::find(names, text.substr(0, comma));
  const auto second = std::ranges::find(names, text.substr(std::min(comma + 1, text.size())));
  if (first == names.end() || second == names.end()) {
    throw UsageError(fmt::format("{}: '{}' is not two of {}, such as {},{}", name, text,
                                 fmt::join(names, ", "), names[0], names[1]));
  }
  if (first == second) {
    throw UsageError(fmt::format("{}: '{}' names one coordinate twice", name, text));
  }
  return {static_cast<int>(first - names.begin()), static_cast<int>(second - names.begin())};
}

bool is_si(const std::string& text) {
  if (text != "si") {
    throw UsageError(fmt::format("units: '{}' is not si", text));
  }
  return true;
}

Jobs jobs(std::optional<int> threads) {
  return Jobs(threads ? static_cast<std::size_t>(*threads)
                      : std::max(1U, std::thread::hardware_concurrency()));
}

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
