// stickslip simulate: the motion under the friction law from any state.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "cli/answers/asked.hpp"
#include "cli/answers/machine_answers.hpp"
#include "cli/commands/answer.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sample_lines.hpp"
#include "core/interruption.hpp"
#include "numeric/simulation/record.hpp"
#include "numeric/simulation/simulation.hpp"
#include "report/orbits/record_json.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::motion;
using namespace numeric::simulation;
using proofs::methods::Examples;
using report::orbits::PictureSamples;
using report::orbits::Simulated;
using report::orbits::Units;

namespace {

// What becomes of the samples while the motion is followed.
class Samples {
 public:
  Samples(const SimulateOptions& options, double period, const Units& units)
      : units_(units), lines_(options, report::orbits::csv_names(report::orbits::coordinates_in(units))) {
    if (options.plot) {
      picture_.emplace(units.time(period));
    }
  }

  [[nodiscard]] bool wanted() const { return picture_ || lines_.wanted(); }

  void add(const Sample& in_data) {
    const Sample sample = units_.sample(in_data);
    if (picture_) {
      picture_->add(sample);
    }
    if (lines_.wanted()) {
      lines_.add(report::orbits::csv_line(sample));
    }
  }

  void write_rest(const Record& record, const SimulateOptions& options) {
    lines_.complete();
    if (picture_) {
      report::tools::write_plot(
          *options.plot, report::orbits::plot_script(units_.record(record), *picture_,
                                                     report::tools::plot_format(*options.plot), units_));
    }
    lines_.take_place();
  }

 private:
  Units units_;
  SampleLines lines_;
  std::optional<PictureSamples> picture_;
};

// The same motion of a machine in tables.
SimulateOptions as_typed(const MotionAsked& asked, const SimulateOptions& o, const Units& units) {
  SimulateOptions options = without_machine(o);
  if (!options.state) {
    const model::Vector4<double> X = units.state(asked.from.start.X);
    options.state = State(X.begin(), X.end());
    options.perturb.reset();
  }
  options.orbit.clear();
  options.typed.erase("--orbit");
  options.parameters = {{"phi", fmt::format("{:.17g}", asked.from.start.phi)}};
  return options;
}

// Without settling.
Simulated simulate(const MotionAsked& asked, const SimulateOptions& options, const Units& units) {
  Simulated simulated;
  simulated.periods = asked.periods;
  const Interruptible scope;
  Samples samples(options, asked.period(), units);
  if (samples.wanted()) {
    simulated.every = asked.every;
  }
  Progress progress("simulating ...");
  simulated.record = record_motion(
      asked.from.start, {simulated.periods * asked.period(), simulated.every},
      [&progress](double share) {
        progress.show("simulating:", share);
        return !interrupted();
      },
      [&samples](const Sample& sample) { samples.add(sample); });
  samples.write_rest(simulated.record, options);
  return simulated;
}

}  // namespace

ExitCode run(const SimulateOptions& options, const Examples& examples) {
  if (const auto done = run_in_tables(options)) {
    return *done;
  }
  require_places(options);
  const auto [file, units, asked] = [&] {
    const Progress progress("searching for orbits ...");
    return asked_motion(options.set ? as_text(options) : options, examples);
  }();
  if (!asked.from.leaves.empty()) {
    tell(asked.from.leaves);
  }
  if (options.set) {
    return run_set(as_tables(asked.from.machine, file, units, "--set"), as_typed(asked, options, units));
  }
  Simulated simulated = simulate(asked, options, units);
  if (are_for_output(options)) {
    return exit_of(simulated.record.interrupted, true);
  }
  {
    const Interruptible scope;
    simulated.settles = settles_on(simulated.record, asked.from.machine);
  }
  print_result(simulated, file, options.json, units);
  return exit_of(simulated.record.interrupted, true);
}

}  // namespace stickslip::cli
