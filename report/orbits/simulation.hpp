// A simulated motion for readers: text, JSON, picture; its table is that of any (record_json.hpp).
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/simulation/record.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// A record, how many periods of the load it was to have, and what the motion settles on, if that was seen.
struct Simulated {
  numeric::simulation::Record record;
  double periods = 0;
  std::optional<double> every;
  std::optional<numeric::attractors::Attractor> settles;
};

// The data; how long; shares of slip, overshoot and stick; energy; what it settles on; the first and the last
// events. The data are those of (2) in any units.
[[nodiscard]] std::string terminal_report(const Simulated& simulated, const tools::Style& style,
                                          const Units& units = {});

// Numbers are in double, all but the data in the units. Absent: the energy without samples, `settles` where
// it was not seen.
[[nodiscard]] tools::Json to_json(const Simulated& simulated, const Units& units = {});
[[nodiscard]] tools::File simulation_schema();

// The samples that a picture shows, a bounded number of them whatever the length of the motion: the last
// ones, and some from the beginning to the end.
class PictureSamples {
 public:
  explicit PictureSamples(double period) : period_(period) {}

  void add(const numeric::simulation::Sample& sample);
  // Those of the last periods, and before them up to most_points in all.
  [[nodiscard]] const std::deque<numeric::simulation::Sample>& last() const { return last_; }
  // Each as far from the next.
  [[nodiscard]] const std::vector<numeric::simulation::Sample>& all_times() const { return all_times_; }

  static constexpr std::size_t most_points = 20000;  // of a curve
  static constexpr double periods_at_end = 3;

 private:
  double period_;
  std::deque<numeric::simulation::Sample> last_;
  std::vector<numeric::simulation::Sample> all_times_;
  std::size_t count_ = 0, stride_ = 1;
};

// The samples from a time on as blocks of a script, one for each kind of phase that there is: [{"block",
// "kind", "colour", "table": lines t x1 x2 x1' x2' E, "first": of them}].
[[nodiscard]] tools::Json phase_tables(const std::deque<numeric::simulation::Sample>& samples,
                                       double from = 0);

// The script for gnuplot: phase portraits of both masses, the motion (its last samples) thin and its last
// three periods in the colours of their phases; the speed of mass 2 against the belt's in those; the energy
// over all times. Record and samples are in the units.
[[nodiscard]] std::string plot_script(const numeric::simulation::Record& record,
                                      const PictureSamples& samples, tools::PlotFormat format,
                                      const Units& units = {});

}  // namespace stickslip::report::orbits
