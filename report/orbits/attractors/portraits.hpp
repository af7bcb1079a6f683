// Attractors as pictures: phase portraits, and the states once a period of the load.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// What a picture shows of a motion, in double; in the units of the text.
struct Portrait {
  static constexpr long most_drawn = 20;     // periods of the load, of the curves
  static constexpr long most_states = 2000;  // of the section
  static constexpr double samples_in_period = 240;

  std::deque<numeric::simulation::Sample> samples;  // from a time of load phase 0 on
  std::vector<model::Vector4<double>> once;         // states at load phase 0, one period apart
  long drawn = 0;                                   // periods that the samples are over
};

// Of the motion from X = (x, x') at load phase theta over so many periods, as far as the bounds allow; with a
// load so many of its states that are one period apart. `masses`: those that are shown, the one on the belt
// last. Less of it after an interruption.
[[nodiscard]] Portrait portrait(const model::FrictionOscillator<double>& oscillator, const Eigen::VectorXd& X,
                                double theta, double period, long periods, long states,
                                const std::array<std::size_t, 2>& masses);
// Of a motion that settled: a periodic one over its n periods. Assumes that the load is not too slow to be
// followed.
[[nodiscard]] Portrait portrait(const numeric::words::WordQuestion& machine,
                                const numeric::attractors::Attractor& attractor, const Units& units = {});

// Of a number of each member: never empty.
template <class Range, class Of>
[[nodiscard]] numeric::simulation::Extremes extremes(const Range& range, const Of& of) {
  numeric::simulation::Extremes e{of(*range.begin()), of(*range.begin())};
  for (const auto& member : range) {
    e = {std::min(e.least, of(member)), std::max(e.greatest, of(member))};
  }
  return e;
}

// Which masses they are, counted from 0: one or two, the one on the belt last.
struct PortraitLabels {
  std::vector<std::size_t> masses{0, 1};
  bool in_SI = false;
};

// The script for gnuplot: (x, x') of each mass in the colours of the phases; that of the mass on the belt
// once a period of the load, a Poincaré section, if there are such states.
[[nodiscard]] std::string plot_script(const Portrait& portrait, tools::PlotFormat format,
                                      tools::PlotShape shape, const PortraitLabels& labels = {});

// The same for one who does not see it.
[[nodiscard]] std::string picture_in_words(const Portrait& portrait, const PortraitLabels& labels = {});

}  // namespace stickslip::report::orbits
