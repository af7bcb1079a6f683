// Orbits as pictures.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

// The script for gnuplot that draws the admissible orbits, or all if none is admissible, or the one named:
// for each the phase portraits of both masses, the phases in the line weights of Fig. 3, and the
// displacements and velocities over one period with the times at which the phases change; an arrow in each
// phase of a portrait shows the direction of motion, a dot where the phase begins. (z_i, z_i') for
// orbits that stick, (x_i, x_i') for those that do not, as in the paper. Drawn from midpoints in double: a
// picture proves nothing. In the units of (2), whatever the units; of these only the machine is taken, for
// the title. Empty when there is no orbit.
[[nodiscard]] std::string plot_script(const numeric::OrbitList& list, tools::PlotFormat format,
                                      tools::PlotShape shape = tools::PlotShape::wide,
                                      std::optional<std::size_t> only = std::nullopt,
                                      const Units& units = {});

// The same picture for one who does not see it: of each orbit its phases and their times, the extent of each
// displacement and velocity, and the belt's velocity; from midpoints in double.
[[nodiscard]] std::string picture_in_words(const numeric::OrbitList& list,
                                           std::optional<std::size_t> only = std::nullopt);

// What arrows, dots and line widths mean, and the units, in half a sentence.
[[nodiscard]] std::string meaning_of_picture();

}  // namespace stickslip::report::orbits
