// stickslip simulate: the motion under the friction law from any state.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/machine_file.hpp"
#include "cli/numbers.hpp"
#include "cli/orbit_data.hpp"
#include "cli/output.hpp"
#include "core/decimal.hpp"
#include "core/interruption.hpp"
#include "numeric/simulation/record.hpp"
#include "proofs/methods/example_orbits.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::motion;
using namespace numeric::simulation;
using proofs::methods::Example;
using proofs::methods::Paper;

namespace {

// A bar on a terminal's standard error.
class Bar {
 public:
  Bar() : shown_(::isatty(STDERR_FILENO) != 0) {}
  ~Bar() {
    if (drawn_) {
      std::fputs("\r\x1b[K", stderr);
    }
  }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void show(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) {
      return;
    }
    constexpr int width = 40;
    const auto done = static_cast<std::size_t>(share * width);
    fmt::print(stderr, "\rsimulating [{}{}] {:3.0f} %", std::string(done, '#'),
               std::string(width - done, '.'), 100 * share);
    std::fflush(stderr);
    last_ = now;
    drawn_ = true;
  }

 private:
  bool shown_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// The beginning of the example's orbit.
Start start_of_example(const Example& example) {
  const Orbit& orbit = printed_orbit(example);
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

void replace(double& value, const TypedParameters& typed, const char * name) {
  if (const auto found = typed.find(name); found != typed.end()) {
    value = number(name, found->second);
  }
}

// What the options say goes before what the file says.
TypedParameters typed_of(const SimulateOptions& options, const ParameterFile& file) {
  TypedParameters typed = file.parameters;
  if (file.machine) {
    typed["phi"] = to_string(file.machine->machine.load_phase);
  }
  for (const auto& [name, text] : options.parameters) {
    typed[name] = text;
  }
  return typed;
}

Start start_of(const SimulateOptions& options, const TypedParameters& typed, const Paper& paper) {
  if (options.example.empty() && options.state.empty()) {
    throw UsageError("a start is missing: give --state x1,x2,x1',x2' or --example");
  }
  Start start;
  if (!options.example.empty()) {
    start = start_of_example(example_named(paper.examples, options.example));
  } else {
    for (const char * name : parameter_names) {
      if (!typed.contains(name)) {
        throw UsageError(
            fmt::format("the parameter {0} is missing: give --{0}, or all by --params or --example", name));
      }
    }
  }
  model::Parameters<double>& a = start.data;
  replace(a.chi, typed, "chi");
  replace(a.eta, typed, "eta");
  replace(a.us, typed, "us");
  replace(a.V, typed, "V");
  replace(a.omega, typed, "omega");
  replace(a.p, typed, "p");
  replace(start.phi, typed, "phi");
  replace(start.ur, typed, "ur");
  if (!options.state.empty()) {
    start.X = four_numbers("state", options.state);
  }
  if (!options.perturb.empty()) {
    start.X += four_numbers("perturb", options.perturb);
  }
  return start;
}

RecordPlan plan_of(const SimulateOptions& options, const Start& start) {
  const double period = 2 * std::acos(-1.0) / start.data.omega;
  const double periods =
      options.periods.empty() ? SimulateOptions::default_periods : positive("periods", options.periods);
  const bool keep = !options.csv.empty() || !options.plot.empty();
  return {
      periods * period,
      options.every.empty() ? period / SimulateOptions::samples_in_period : positive("every", options.every),
      keep};
}

void write(const Record& record, const SimulateOptions& options) {
  if (!options.csv.empty()) {
    const std::filesystem::path file = options.csv;
    report::tools::write_files(file.has_parent_path() ? file.parent_path() : ".",
                               {{file.filename().string(), report::orbits::to_csv(record)}});
  }
  if (!options.plot.empty()) {
    report::tools::write_plot(options.plot,
                              report::orbits::plot_script(record, report::tools::plot_format(options.plot)));
  }
}

Record simulate(const Start& start, const RecordPlan& plan) {
  const Interruptible scope;
  Bar bar;
  return record_motion(start, plan, [&bar](double share) {
    bar.show(share);
    return !interrupted();
  });
}

// So many steps of a simulation, roughly, take a second.
constexpr double enough_steps = 1e6;
constexpr double fewest_periods = 100;
// Beyond this a motion of the largest data could leave what a simulation can begin with.
constexpr double greatest_state = 1e90;

// What the motion settles on, if that can be seen within a second or so, when it goes on from its end.
std::string settles_on(const Record& record, const SimulateOptions& options, TypedParameters typed,
                       const Paper& paper) {
  typed.erase("phi");
  const double fastest =
      std::max({1.0, model::modes<double>(record.start.data.chi, record.start.data.eta).omega2,
                record.start.data.omega});
  const double periods = std::min(enough_steps / (record.period * fastest),
                                  static_cast<double>(AttractorsOptions::default_most_periods));
  if (!(periods >= fewest_periods)) {
    return "";
  }
  const words::WordQuestion data = machine(paper, typed, {}, options.example, OrbitsOptions::default_digits);
  // On to the next time when the load's phase is 0.
  const Start& start = record.start;
  const double turn = 2 * std::acos(-1.0);
  const double phase = std::fmod(start.phi + start.data.omega * record.done, turn);
  Simulation simulation(start.data, start.ur, phase, record.end.X);
  simulation.advance((phase > 0 ? turn - phase : -phase) / start.data.omega);
  const Interruptible scope;
  const attractors::Attractor found =
      attractors::find_attractor(data, simulation.state(), static_cast<long>(periods));
  return interrupted() ? "" : report::orbits::in_words(found);
}

}  // namespace

ExitCode run(const SimulateOptions& options, const Paper& paper) {
  if (!options.csv.empty()) {
    report::tools::require_writable_file(options.csv);
  }
  if (!options.plot.empty()) {
    (void)report::tools::plot_format(options.plot);
    report::tools::require_plot(options.plot);
  }
  const ParameterFile file =
      read_parameters(options.file, options.parameters, options.example, FrictionAtRest::needed);
  const TypedParameters typed = typed_of(options, file);
  const Start start = start_of(options, typed, paper);
  const Record record = simulate(start, plan_of(options, start));
  write(record, options);
  const bool within = record.end.X.lpNorm<Eigen::Infinity>() < greatest_state;
  const std::string settles = within && !record.interrupted ? settles_on(record, options, typed, paper) : "";
  print(machine_report(file) + report::orbits::terminal_report(record, settles, terminal_style()));
  return record.interrupted ? exit_interrupted : exit_decided;
}

}  // namespace stickslip::cli
