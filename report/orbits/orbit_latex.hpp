// One orbit for a paper.
#pragma once

#include <cstddef>
#include <string>

#include "numeric/orbits.hpp"

namespace stickslip::report::orbits {

// Orbit `index` of a list that is none of a box, as LaTeX for a document with amsmath: a comment with the
// command that lists it, its data, its values, what is proved of it, and phase by phase the closed forms of
// x_1 and x_2, (5), (8) or (10), with its numbers: to at most so many significant digits, each of them right
// to one unit of the last one.
[[nodiscard]] std::string orbit_latex(const numeric::OrbitList& list, std::size_t index, int digits);

}  // namespace stickslip::report::orbits
