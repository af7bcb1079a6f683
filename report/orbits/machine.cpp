#include "report/orbits/machine.hpp"

#include <fmt/format.h>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace tools;

namespace {

constexpr int digits = 8;

// Enough to see by how little the last digit of the data changes the machine.
constexpr long bits = 256;

std::string in_SI(const MachineInSI& m) {
  const std::string at_rest =
      m.friction_at_rest ? fmt::format(", {} N at rest", to_string(*m.friction_at_rest)) : "";
  const std::string phase =
      m.load_phase == 0 ? "" : fmt::format(", phase {} at t = 0 in simulations", to_string(m.load_phase));
  return fmt::format(
      "m1 = {} kg, m2 = {} kg, k1 = {} N/m, k2 = {} N/m, friction {} N sliding{}, belt {} m/s, "
      "load {} N at {} Hz{}",
      to_string(m.m1), to_string(m.m2), to_string(m.k1), to_string(m.k2), to_string(m.friction_sliding),
      at_rest, to_string(m.belt_velocity), to_string(m.load_amplitude), to_string(m.load_frequency), phase);
}

std::string dimensionless(const DataTaken& taken) {
  const motion::ExactParameters& a = taken.data;
  return fmt::format("chi={}, eta={}, us={}, V={}, omega={}, p={}{}", to_string(a.chi), to_string(a.eta),
                     to_string(a.us), to_string(a.V), to_string(a.omega), to_string(a.p),
                     taken.ur ? ", ur=" + to_string(*taken.ur) : "");
}

// |data · unit / given - 1|, rounded up.
std::string change(const Rational& data, const Ball& unit, const Rational& given) {
  const Ball relative = Ball(data) * unit / Ball(given) - Ball(1);
  return fmt::format("{:.1e}", abs(relative).upper().approximate() * 1.06);
}

std::string exactness(const DataTaken& taken) {
  const WorkingPrecision precision(bits);
  const std::string frequency =
      fmt::format("load_frequency changed by less than {} of itself",
                  change(taken.data.omega, taken.frequency(), taken.machine.load_frequency));
  const std::string belt =
      taken.rounded_V ? fmt::format(" and belt_velocity by less than {}",
                                    change(taken.data.V, taken.velocity(), taken.machine.belt_velocity))
                      : "";
  return fmt::format(
      "{} rounded to {} digits, all else is exact: everything below holds for the data taken, "
      "which are this machine with {}{}",
      taken.rounded_V ? "omega and V are" : "omega is", DataTaken::digits, frequency, belt);
}

std::string unit_of_length(int thousands) {
  switch (thousands) {
    case 0:
      return "m";
    case -1:
      return "mm";
    case -2:
      return "um";
    default:
      return fmt::format("1e{} m", 3 * thousands);
  }
}

std::string units(const DataTaken& taken) {
  const WorkingPrecision precision(bits);
  return fmt::format(
      "x, V, p, us, ur are in {}; t = 1 is {} s, x' = 1 is {} m/s, u = 1 is {} N, omega = 1 is "
      "{} Hz",
      unit_of_length(taken.thousands), rounded(Ball(1) / taken.Omega(), digits),
      rounded(taken.velocity(), digits), rounded(taken.force(), digits), rounded(taken.frequency(), digits));
}

std::string natural_frequencies(const DataTaken& taken) {
  const WorkingPrecision precision(bits);
  const model::Modes<Ball> modes = model::modes<Ball>(Ball(taken.data.chi), Ball(taken.data.eta));
  return fmt::format("{} Hz and {} Hz", rounded(modes.omega1 * taken.frequency(), digits),
                     rounded(modes.omega2 * taken.frequency(), digits));
}

}  // namespace

std::string terminal_report(const DataTaken& taken, const Style& style) {
  return columns_of({{{"A machine in SI units", bold(style)}}}, style.width) +
         columns_of({{{"machine"}, {in_SI(taken.machine)}},
                     {{"natural"}, {natural_frequencies(taken)}},
                     {{"data taken"}, {dimensionless(taken)}},
                     {{"exactness"}, {exactness(taken)}},
                     {{"units"}, {units(taken)}}},
                    style.width) +
         "\n";
}

Json to_json(const DataTaken& taken) {
  const WorkingPrecision precision(bits);
  const MachineInSI& m = taken.machine;
  Json si = {{"m1", to_string(m.m1)},
             {"m2", to_string(m.m2)},
             {"k1", to_string(m.k1)},
             {"k2", to_string(m.k2)},
             {"friction_sliding", to_string(m.friction_sliding)},
             {"belt_velocity", to_string(m.belt_velocity)},
             {"load_amplitude", to_string(m.load_amplitude)},
             {"load_frequency", to_string(m.load_frequency)},
             {"load_phase", to_string(m.load_phase)}};
  if (m.friction_at_rest) {
    si["friction_at_rest"] = to_string(*m.friction_at_rest);
  }
  const auto ball = [](const Ball& value) { return to_json(value, DataTaken::digits); };
  Json json = {{"si", si},
               {"units",
                {{"length", ball(taken.length())},
                 {"time", ball(Ball(1) / taken.Omega())},
                 {"velocity", ball(taken.velocity())},
                 {"force", ball(taken.force())},
                 {"frequency", ball(taken.frequency())}}},
               {"rounded", {"omega"}}};
  if (taken.rounded_V) {
    json["rounded"].push_back("V");
  }
  return json;
}

Ball Units::time(const Ball& t) const {
  return si_ ? t / si_->Omega() : t;
}
Ball Units::length(const Ball& x) const {
  return si_ ? x * si_->length() : x;
}
Ball Units::velocity(const Ball& v) const {
  return si_ ? v * si_->velocity() : v;
}

model::Vector4<double> Units::state(const model::Vector4<double>& X) const {
  if (!si_) {
    return X;
  }
  const double length = si_->length().approximate(), velocity = si_->velocity().approximate();
  return {length * X(0), length * X(1), velocity * X(2), velocity * X(3)};
}

Units::Measured Units::measured(const families::NamedBall& value) const {
  const std::string& name = value.name;
  if (name == "phi") {
    return {value.value, " rad"};
  }
  if (!si_) {
    return {value.value, ""};
  }
  if (name.starts_with("ur")) {
    return {value.value * si_->force(), " N"};
  }
  if (name.starts_with("t") || name.starts_with("T")) {
    return {time(value.value), " s"};
  }
  if (name.find("dot") != std::string::npos) {
    return {velocity(value.value), " m/s"};
  }
  if (name.starts_with("x") || name.starts_with("z")) {
    return {length(value.value), " m"};
  }
  throw InternalError("a value of an orbit without a unit: " + name);
}

std::string Units::text(const families::NamedBall& value, int digits) const {
  // So that the factor does not take any of the digits.
  const WorkingPrecision precision(static_cast<long>(3.33 * digits) + bits);
  const Measured m = measured(value);
  return to_string(m.value, known_digits(m.value, digits)) + m.unit;
}

std::string Units::short_text(const families::NamedBall& value, int digits) const {
  const WorkingPrecision precision(bits);
  const Measured m = measured(value);
  return rounded(m.value, digits) + m.unit;
}

}  // namespace stickslip::report::orbits
