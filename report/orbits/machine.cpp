#include "report/orbits/machine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "model/machine_values.hpp"
#include "model/named_data.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::simulation;
using namespace tools;

namespace {

// Enough to see by how little the last digit of the data changes the machine.
constexpr long bits = 256;

// The masses and springs, and the rest; without the value that the machine's file has under the name.
std::array<std::string, 2> in_SI(const MachineInSI& m, const std::string& but_for = "") {
  using Words = std::vector<std::string>;
  const auto add = [&](Words& words, const char * name, const std::string& text) {
    if (but_for != name) {
      words.push_back(text);
    }
  };
  const auto after = [](const char * label, const Words& words, const char * separator) {
    return words.empty() ? "" : fmt::format("{} {}", label, fmt::join(words, separator));
  };
  Words first, friction, load;
  add(first, "m1", "m1 = " + to_string(m.m1) + " kg");
  add(first, "m2", "m2 = " + to_string(m.m2) + " kg");
  add(first, "k1", "k1 = " + to_string(m.k1) + " N/m");
  add(first, "k2", "k2 = " + to_string(m.k2) + " N/m");
  // By either of its names: friction is a force, or a coefficient of the normal force.
  const bool varies = but_for == "normal_force";
  if (!varies && but_for != "friction_sliding") {
    add(friction, "friction_force_sliding", to_string(m.friction_sliding) + " N sliding");
  }
  if (m.friction_at_rest && !varies && but_for != "friction_at_rest") {
    add(friction, "friction_force_at_rest", to_string(*m.friction_at_rest) + " N at rest");
  }
  add(load, "load_amplitude", to_string(m.load_amplitude) + " N");
  add(load, "load_frequency", "at " + to_string(m.load_frequency) + " Hz");
  Words rest{after("friction", friction, ", ")};
  add(rest, "belt_velocity", "belt " + to_string(m.belt_velocity) + " m/s");
  rest.push_back(after("load", load, " "));
  if (m.load_phase != 0) {
    add(rest, "load_phase", "phase " + to_string(m.load_phase) + " at t = 0 in simulations");
  }
  std::erase(rest, "");
  return {fmt::format("{}", fmt::join(first, ", ")), fmt::format("{}", fmt::join(rest, ", "))};
}

std::string dimensionless(const DataTaken& taken) {
  return parameter_list(model::with_names(taken.data)) + (taken.ur ? ", ur=" + to_string(*taken.ur) : "");
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

std::string units(const DataTaken& taken, int digits) {
  const WorkingPrecision precision(bits);
  return fmt::format(
      "x, V, p, us, ur are in {}; t = 1 is {} s, x' = 1 is {} m/s, u = 1 is {} N, omega = 1 is "
      "{} Hz",
      unit_of_length(taken.thousands), rounded(Ball(1) / taken.Omega(), digits),
      rounded(taken.velocity(), digits), rounded(taken.force(), digits), rounded(taken.frequency(), digits));
}

std::string natural_frequencies(const DataTaken& taken, int digits) {
  const WorkingPrecision precision(bits);
  const model::Modes<Ball> modes = model::modes<Ball>(Ball(taken.data.chi), Ball(taken.data.eta));
  return fmt::format("{} Hz and {} Hz", rounded(modes.omega1 * taken.frequency(), digits),
                     rounded(modes.omega2 * taken.frequency(), digits));
}

// The values of an orbit (numeric/families/orbit.hpp), and in what each is measured.
struct ValueOfOrbit {
  std::string_view name;
  const char * unit;
  Ball (Units::*in_units)(const Ball&) const;  // null of an angle
};
constexpr ValueOfOrbit values_of_orbits[] = {
    {"tau", " s", &Units::time},   {"tau1", " s", &Units::time},         {"tau2", " s", &Units::time},
    {"T", " s", &Units::time},     {"Theta", " s", &Units::time},        {"phi", " rad", nullptr},
    {"z10", " m", &Units::length}, {"z20", " m", &Units::length},        {"x10", " m", &Units::length},
    {"x20", " m", &Units::length}, {"zdot10", " m/s", &Units::velocity}, {"xdot10", " m/s", &Units::velocity},
    {"ur", " N", &Units::force},   {"ur_max", " N", &Units::force}};

const ValueOfOrbit * value_named(const std::string& name) {
  const auto * const known = std::ranges::find(values_of_orbits, name, &ValueOfOrbit::name);
  return known == std::end(values_of_orbits) ? nullptr : known;
}

}  // namespace

std::string in_unit_of(const std::string& name) {
  const model::MachineValue * const value = model::machine_value(name);
  return value == nullptr || *value->unit == '\0' ? "" : std::string(" in ") + value->unit;
}

std::string with_unit(const std::string& name, const std::string& value) {
  const std::string in_unit = in_unit_of(name);
  return name + " = " + value + (in_unit.empty() ? "" : in_unit.substr(std::string(" in").size()));
}

std::vector<Row> machine_rows(const DataTaken& taken, int digits) {
  return {{{"machine"}, {fmt::format("{}", fmt::join(in_SI(taken.machine), ", "))}},
          {{"natural"}, {natural_frequencies(taken, digits)}},
          {{"data taken"}, {dimensionless(taken)}},
          {{"exactness"}, {exactness(taken)}},
          {{"units"}, {units(taken, digits)}}};
}

std::string terminal_report(const DataTaken& taken, const Style& style, int digits) {
  return headed("A machine in SI units", machine_rows(taken, digits), style) + "\n";
}

std::vector<std::pair<std::string, Rational>> values_in_SI(const MachineInSI& m) {
  std::vector<std::pair<std::string, Rational>> values{{"m1", m.m1},
                                                       {"m2", m.m2},
                                                       {"k1", m.k1},
                                                       {"k2", m.k2},
                                                       {"friction_sliding", m.friction_sliding},
                                                       {"belt_velocity", m.belt_velocity},
                                                       {"load_amplitude", m.load_amplitude},
                                                       {"load_frequency", m.load_frequency},
                                                       {"load_phase", m.load_phase}};
  if (m.friction_at_rest) {
    values.emplace_back("friction_at_rest", *m.friction_at_rest);
  }
  return values;
}

void write_machine(Object& json, const DataTaken& taken) {
  const WorkingPrecision precision(bits);
  const auto ball = [](const Ball& value) { return ball_text(value, DataTaken::digits); };
  json.object(
      "si",
      [&](Object& to) {
        to.each(values_in_SI(taken.machine),
                {"m1", "m2", "k1", "k2", "friction_sliding", "belt_velocity", "load_amplitude",
                 "load_frequency", "load_phase"},
                {"friction_at_rest"});
      },
      "In kg, N/m, N, m/s, Hz and rad.");
  json.object(
      "units",
      [&](Object& to) {
        to.has("length", ball(taken.length()));
        to.has("time", ball(Ball(1) / taken.Omega()));
        to.has("velocity", ball(taken.velocity()));
        to.has("force", ball(taken.force()));
        to.has("frequency", ball(taken.frequency()));
      },
      "In m, s, m/s, N and Hz: of the lengths x, V, p, us and ur, of t, x', u and omega.");
  std::vector<std::string> rounded{"omega"};
  if (taken.rounded_V) {
    rounded.emplace_back("V");
  }
  json.has("rounded", rounded,
           with({{"items", one_of({"omega", "V"})}},
                "The parameters that are irrational for this machine: a decimal near them is taken."));
}

Json to_json(const DataTaken& taken) {
  return written(taken, write_machine);
}

Units::Units(const DataTaken& si, int most_digits)
    : machine_(si.machine),
      most_digits_(most_digits),
      si_(si),
      factors_{1 / si.Omega().approximate(), si.length().approximate(), si.velocity().approximate(),
               si.force().approximate(), 0} {
  factors_.energy = si.machine.m1.get_d() * factors_.velocity * factors_.velocity;
}

Units Units::dimensionless(const DataTaken& taken, int most_digits) {
  Units units;
  units.machine_ = taken.machine;
  units.most_digits_ = most_digits;
  return units;
}

std::string Units::machine_or(const std::string& data, const std::string& but_for) const {
  return machine_ ? fmt::format("{}", fmt::join(in_SI(*machine_, but_for), ",\\n")) : data;
}

std::string Units::labelled(const std::string& name, const char * unit) const {
  return si_ ? fmt::format("{} in {}", name, unit) : name;
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
Ball Units::force(const Ball& f) const {
  return si_ ? f * si_->force() : f;
}

model::Vector4<double> Units::state(const model::Vector4<double>& X) const {
  const double x = factors_.length, v = factors_.velocity;
  return {x * X(0), x * X(1), v * X(2), v * X(3)};
}
model::Vector4<double> Units::of_state(const model::Vector4<double>& told) const {
  const double x = factors_.length, v = factors_.velocity;
  return {told(0) / x, told(1) / x, told(2) / v, told(3) / v};
}

Sample Units::sample(Sample s) const {
  s.time *= factors_.time;
  s.X = state(s.X);
  s.r *= factors_.force;
  s.u *= factors_.force;
  s.energy *= factors_.energy;
  return s;
}

Record Units::record(Record r) const {
  r.start.X = state(r.start.X);
  for (double * const time : {&r.period, &r.done, &r.time_in[0], &r.time_in[1], &r.time_in[2]}) {
    *time *= factors_.time;
  }
  for (std::vector<Transition> * const events : {&r.first_events, &r.last_events}) {
    for (Transition& e : *events) {
      e.time *= factors_.time;
      e.r *= factors_.force;
      e.X = state(e.X);
    }
  }
  if (r.energy) {
    r.energy->least *= factors_.energy;
    r.energy->greatest *= factors_.energy;
  }
  r.end = sample(r.end);
  return r;
}

bool is_time(const std::string& name) {
  const ValueOfOrbit * const known = value_named(name);
  return known != nullptr && known->unit == std::string_view(" s");
}

Units::Measured Units::measured(const families::NamedBall& value) const {
  const ValueOfOrbit * const known = value_named(value.name);
  if (known == nullptr) {
    throw InternalError("a value of an orbit without a unit: " + value.name);
  }
  if (known->in_units == nullptr) {
    return {value.value, known->unit};
  }
  return si_ ? Measured{(this->*known->in_units)(value.value), known->unit} : Measured{value.value, ""};
}

long Units::bits_for(int digits) {
  return static_cast<long>(3.33 * digits) + bits;
}

Ball Units::value(const families::NamedBall& value, int digits) const {
  const WorkingPrecision precision(bits_for(digits));
  return measured(value).value;
}

Ball Units::time(const Ball& t, int digits) const {
  const WorkingPrecision precision(bits_for(digits));
  return time(t);
}

std::string Units::text(const families::NamedBall& value, int asked) const {
  const int digits = this->digits(asked);
  const WorkingPrecision precision(bits_for(digits));
  const Measured m = measured(value);
  return to_string(m.value, known_digits(m.value, digits)) + m.unit;
}

std::string Units::short_text(const families::NamedBall& value, int digits) const {
  const WorkingPrecision precision(bits);
  const Measured m = measured(value);
  return rounded(m.value, digits) + m.unit;
}

}  // namespace stickslip::report::orbits
