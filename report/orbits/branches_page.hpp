// Branches of orbits as a page for the browser, with the bifurcation diagram.
#pragma once

#include <vector>

#include "numeric/branches/branches.hpp"
#include "report/orbits/page.hpp"

namespace stickslip::report::orbits {

// The files of one directory: index.html with its style sheets, branches.json and branches.csv, and the
// diagram if there is something to draw, as branches.svg, branches-narrow.svg and branches.pdf. Throws
// InputOutputError if a program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> pages(const numeric::branches::BranchList& list,
                                             const PageFrame& frame = {});

}  // namespace stickslip::report::orbits
