// The orbits that the paper's examples speak of, proved.
#pragma once

#include "numeric/examples.hpp"
#include "numeric/orbits.hpp"

namespace stickslip {

// What `orbits` is asked for the data of the example.
[[nodiscard]] OrbitQuestion question_of(const Example& example, int digits = 20);

// The admissible orbit whose values are nearest to the printed ones. Throws InternalError when there is none.
[[nodiscard]] DecidedOrbit printed_orbit(const Example& example, int digits = 20);

}  // namespace stickslip
