#include "cli/answers/asked.hpp"

#include <fmt/format.h>

#include <string>

#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "core/interruption.hpp"
#include "model/named_data.hpp"
#include "numeric/attractors/settle.hpp"
#include "numeric/families/family.hpp"
#include "proofs/methods/motions.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::motion;
using namespace numeric::simulation;
using proofs::methods::Examples;

namespace {

constexpr int digits_of_ur = 17;

// So many steps of a simulation, roughly, take a second.
constexpr double enough_steps = 1e6;
constexpr double fewest_periods = 100;
// Beyond this a motion of the largest data could leave what a simulation can begin with.
constexpr double greatest_state = 1e90;

// The beginning of the orbit.
Start start_of_orbit(const Orbit& orbit) {
  const MotionOf<double> motion = in_double(orbit.motion);
  const PhaseOf<double>& first = motion.phases.front();
  Start start{motion.oscillator.data, 0, first.load, first.Z};
  start.X.head<2>() += motion.oscillator.d0;
  for (const NamedBall& value : orbit.values) {
    if (value.name == "ur") {
      start.ur = value.value.approximate();
    }
  }
  return start;
}

SimulationStart from_orbit(const SimulateOptions& options, ParameterFile& file, const Examples& examples) {
  const NamedOrbit named = named_orbit(options.orbit, examples, file, OrbitsOptions::default_digits);
  const OrbitQuestion& asked = named.list.question;
  const Orbit& orbit = named.orbit();
  if (!asked.ur && !families::has_stick(*asked.family)) {
    throw UsageError(
        fmt::format("a simulation needs --ur: the largest that the orbit {} allows, ur_max, is {}",
                    options.orbit, report::tools::rounded(orbit.value("ur_max"), 5)));
  }
  std::string leaves;
  if (orbit.admissible.truth == Truth::refuted) {
    leaves = fmt::format("The orbit {} is {}; the motion leaves it.", options.orbit,
                         report::orbits::verdict_on(orbit));
  }
  const model::Parameters<Range>& a = asked.parameters;
  const Rational ur =
      asked.ur ? asked.ur->middle : parse_rational(to_text(orbit.value("ur"), digits_of_ur).mid);
  return {start_of_orbit(orbit),
          {{a.chi.middle, a.eta.middle, a.us.middle, a.V.middle, a.omega.middle, a.p.middle},
           ur,
           OrbitsOptions::default_digits},
          leaves};
}

// From a state, or from the orbit of an example.
SimulationStart from_state(const SimulateOptions& options, const ParameterFile& file,
                           const Examples& examples, const report::orbits::Units& units) {
  TypedParameters typed = file.parameters;
  if (file.machine) {
    typed["phi"] = to_string(file.machine->machine.load_phase);
  }
  for (const auto& [name, text] : options.parameters) {
    typed[name] = text;
  }
  Start start;
  if (!options.example.empty()) {
    start = start_of_orbit(printed_orbit(example_named(examples, options.example)));
  } else {
    require_given(typed, {parameter_names.begin(), parameter_names.end()});
  }
  const auto replace = [&typed](double& value, const char * name) {
    if (const auto found = typed.find(name); found != typed.end()) {
      value = number(name, found->second);
    }
  };
  for (const auto& [name, datum] : model::named_data<double>) {
    replace(start.data.*datum, name);
  }
  replace(start.phi, "phi");
  replace(start.ur, "ur");
  if (options.state) {
    start.X = in_data("state", *options.state, units);
  }
  ParameterFile of_machine;
  of_machine.example = options.example;
  of_machine.typed = typed;
  of_machine.typed.erase("phi");
  return {start, machine(examples, of_machine, OrbitsOptions::default_digits)};
}

}  // namespace

SimulationStart simulation_start(const SimulateOptions& options, ParameterFile& file,
                                 const Examples& examples, const report::orbits::Units& units) {
  if (options.example.empty() && !options.state && options.orbit.empty()) {
    throw UsageError("a start is missing: give --state x1,x2,x1',x2', --example or --orbit");
  }
  SimulationStart from = options.orbit.empty() ? from_state(options, file, examples, units)
                                               : from_orbit(options, file, examples);
  if (options.perturb) {
    from.start.X += in_data("perturb", *options.perturb, units);
  }
  return from;
}

std::optional<attractors::Attractor> settles_on(const Record& record, const words::WordQuestion& machine) {
  if (record.interrupted || !(record.end.X.lpNorm<Eigen::Infinity>() < greatest_state)) {
    return std::nullopt;
  }
  const double fastest =
      std::max({1.0, model::modes<double>(record.start.data.chi, record.start.data.eta).omega2,
                record.start.data.omega});
  const double periods = std::min(enough_steps / (record.period * fastest),
                                  static_cast<double>(AttractorsOptions::default_most_periods));
  if (!(periods >= fewest_periods)) {
    return std::nullopt;
  }
  Start end = record.start;
  end.phi += end.data.omega * record.done;
  end.X = record.end.X;
  attractors::Attractor found =
      attractors::find_attractor(machine, attractors::at_phase_0(end), static_cast<long>(periods));
  return interrupted() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace stickslip::cli
