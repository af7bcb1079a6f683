#include "cli/machine_box.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/numbers.hpp"
#include "core/decimal.hpp"

namespace stickslip::cli {

using numeric::DataTaken;

namespace {

using Numbers = std::map<std::string, Rational>;
using Ranges = std::map<std::string, std::pair<Rational, Rational>>;

DataTaken taken(const TypedParameters& machine, const std::string& file, std::optional<int> thousands) {
  return numeric::data_taken(machine_in_SI(machine, file, FrictionAtRest::optional), thousands);
}

// One of the two ends of each range, in all ways.
std::vector<TypedParameters> corners(const Ranges& ranges) {
  std::vector<TypedParameters> all(1);
  for (const auto& [name, range] : ranges) {
    std::vector<TypedParameters> more = all;
    for (TypedParameters& corner : all) {
      corner[name] = to_string(range.first);
    }
    for (TypedParameters& corner : more) {
      corner[name] = to_string(range.second);
    }
    if (range.first != range.second) {
      all.insert(all.end(), more.begin(), more.end());
    }
  }
  return all;
}

Numbers numbers(const DataTaken& t, const Rational& length) {
  const numeric::motion::ExactParameters& a = t.data;
  Numbers all{{"chi", a.chi},      {"eta", a.eta},     {"us", a.us / length},
              {"V", a.V / length}, {"omega", a.omega}, {"p", a.p / length}};
  if (t.ur) {
    all["ur"] = *t.ur / length;
  }
  return all;
}

// A decimal beyond x, which is known to half a unit of its last digit.
Rational beyond(const Rational& x, int direction) {
  const Rational share = direction * parse_rational(fmt::format("1e{}", 1 - DataTaken::digits));
  return parse_rational(to_text(Ball(Rational(x * (1 + share))), DataTaken::digits).mid);
}

Ranges box_of(const std::vector<DataTaken>& machines, bool in_us) {
  Ranges box;
  bool rounded_V = false;
  for (const DataTaken& t : machines) {
    rounded_V = rounded_V || t.rounded_V;
    for (const auto& [name, x] : numbers(t, in_us ? t.data.us : Rational(1))) {
      auto& range = box.try_emplace(name, x, x).first->second;
      range = {std::min(range.first, x), std::max(range.second, x)};
    }
  }
  for (auto& [name, range] : box) {
    if (range.first != range.second && (name == "omega" || (name == "V" && rounded_V))) {
      range = {beyond(range.first, -1), beyond(range.second, 1)};
    }
  }
  return box;
}

std::size_t varying(const Ranges& ranges) {
  return static_cast<std::size_t>(std::count_if(
      ranges.begin(), ranges.end(), [](const auto& one) { return one.second.first != one.second.second; }));
}

// What a datum that varies says of the machine, where that is a multiple of it.
std::map<std::string, report::atlas::Machine::InSI> in_SI(const DataTaken& t, const Ranges& ranges,
                                                          bool in_us) {
  const WorkingPrecision precision(256);
  for (const char * name : {"m1", "m2", "k1", "k2"}) {
    const auto& range = ranges.at(name);
    if (in_us || range.first != range.second) {
      return {};
    }
  }
  return {{"omega", {"load_frequency", t.frequency()}},
          {"V", {"belt_velocity", t.velocity()}},
          {"p", {"load_amplitude", t.force() / Ball(t.data.eta)}},
          {"us", {"friction_force_sliding", t.force()}},
          {"ur", {"friction_force_at_rest", t.force()}}};
}

}  // namespace

MachineBox read_machine_box(const std::string& file, const TypedParameters& options,
                            const std::string& example) {
  TypedParameters given;
  const auto in_the_middle = [&](const TypedParameters& machine) {
    given = machine;
    TypedParameters middle;
    for (const auto& [name, text] : machine) {
      const auto [lower, upper] = interval(name, text);
      middle[name] = to_string(Rational((lower + upper) / 2));
    }
    return middle;
  };
  MachineBox result{read_parameters(file, options, example, FrictionAtRest::optional, in_the_middle), {}};
  if (!result.file.machine) {
    return result;
  }
  Ranges ranges;
  for (const auto& [name, text] : given) {
    ranges[name] = interval(name, text);
    result.said.values.emplace_back(name, text);
  }
  std::vector<DataTaken> machines;
  for (const TypedParameters& corner : corners(ranges)) {
    machines.push_back(taken(corner, file, result.file.machine->thousands));
  }
  const Ranges usual = box_of(machines, false), by_us = box_of(machines, true);
  const bool in_us = varying(by_us) < varying(usual);
  const Ranges& box = in_us ? by_us : usual;
  for (const auto& [name, range] : box) {
    const auto& [lower, upper] = range;
    result.file.parameters[name] =
        lower == upper ? to_string(lower) : to_string(lower) + ".." + to_string(upper);
  }
  result.said.axes = in_SI(*result.file.machine, ranges, in_us);
  result.said.holds_more = result.said.axes.empty() || varying(box) != varying(ranges);
  return result;
}

}  // namespace stickslip::cli
