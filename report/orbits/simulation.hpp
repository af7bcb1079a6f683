// A simulated motion for readers: text, CSV, picture.
#pragma once

#include <string>

#include "numeric/simulation/record.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// The data; how long; shares of slip, overshoot and stick; energy; what it settles on, if that is given in
// words; the first and the last events.
[[nodiscard]] std::string terminal_report(const numeric::simulation::Record& record,
                                          const std::string& settles, const tools::Style& style);

// A line of names and one line per sample: t, phase, x1, x2, x1', x2', r, u, E; numbers with 17 digits.
[[nodiscard]] std::string to_csv(const numeric::simulation::Record& record);

// The script for gnuplot: phase portraits of both masses, the motion (its last 20000 samples) thin and its
// last three periods in the colours of their phases; the speed of mass 2 against the belt's in those; the
// energy over all times.
[[nodiscard]] std::string plot_script(const numeric::simulation::Record& record, tools::PlotFormat format);

}  // namespace stickslip::report::orbits
