// stickslip simulate: the motion under the friction law from any state.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "cli/answer.hpp"
#include "cli/asked.hpp"
#include "cli/commands.hpp"
#include "cli/machine_answers.hpp"
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
  // Throws InputOutputError where they cannot go.
  Samples(const SimulateOptions& options, double period, const Units& units) : units_(units) {
    if (options.plot) {
      picture_.emplace(units.time(period));
    }
    to_output_ = options.csv == standard_output;
    if (options.csv && !to_output_) {
      file_.emplace(*options.csv);
    }
    if (options.csv) {
      write(report::orbits::csv_names(report::orbits::coordinates_in(units)));
    }
  }

  [[nodiscard]] bool wanted() const { return picture_ || file_ || to_output_; }

  void add(const Sample& in_data) {
    const Sample sample = units_.sample(in_data);
    if (picture_) {
      picture_->add(sample);
    }
    if (file_ || to_output_) {
      write(report::orbits::csv_line(sample));
    }
  }

  void write_rest(const Record& record, const SimulateOptions& options) {
    if (to_output_) {
      print(output_);
    }
    if (file_) {
      file_->complete();
    }
    if (picture_) {
      report::tools::write_plot(
          *options.plot, report::orbits::plot_script(units_.record(record), *picture_,
                                                     report::tools::plot_format(*options.plot), units_));
    }
    if (file_) {
      file_->take_place();
    }
  }

  static constexpr std::string_view standard_output = "-";

 private:
  void write(std::string_view text) {
    if (file_) {
      file_->append(text);
      return;
    }
    output_ += text;
    if (output_.size() >= chunk) {
      print(output_);
      output_.clear();
    }
  }

  static constexpr std::size_t chunk = 1 << 16;

  Units units_;
  std::optional<PictureSamples> picture_;
  std::optional<report::tools::PendingFile> file_;
  std::string output_;
  bool to_output_ = false;
};

void require_places(const SimulateOptions& options) {
  if (options.csv == Samples::standard_output) {
    if (options.json) {
      throw UsageError("--csv - and --json do not go together: both are for standard output");
    }
    SimulateOptions others = options;
    others.csv.reset();
    require_outputs(others);
    return;
  }
  if (options.csv == "") {
    throw UsageError("csv: '' is not the name of a file");
  }
  require_outputs(options);
}

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
  if (options.csv == Samples::standard_output) {
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
