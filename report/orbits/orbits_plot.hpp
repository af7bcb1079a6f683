// Orbits as pictures.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "numeric/orbits.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// The script for gnuplot that draws the admissible orbits, or all if none is admissible, or the one named:
// for each the phase portraits of both masses, the phases in the line weights of Fig. 3, and the
// displacements and velocities over one period with the times at which the phases change. (z_i, z_i') for
// orbits that stick, (x_i, x_i') for those that do not, as in the paper. Drawn from midpoints in double: a
// picture proves nothing. Empty when there is no orbit.
[[nodiscard]] std::string plot_script(const numeric::OrbitList& list, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide,
                                      std::optional<std::size_t> only = std::nullopt);

}  // namespace stickslip::report::orbits
