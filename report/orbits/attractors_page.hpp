// What a machine does as a page for the browser, with pictures.
#pragma once

#include <optional>
#include <vector>

#include "numeric/attractors/diagram.hpp"
#include "report/orbits/page.hpp"

namespace stickslip::report::orbits {

// The files of one directory: index.html with its style sheets, attractors.json, basins.json or
// diagram.json, but of a diagram along a value in SI units, and the pictures: of each attractor, as far as
// there are not more than most_pictured, its phase portraits and section, portrait-K.svg and
// portrait-K-narrow.svg; basins.svg; diagram.svg. A page on starts shows the basins beside them, if there are
// some. Throws InputOutputError if a program that draws is missing or fails.
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::AttractorList& list,
                                             const std::optional<numeric::attractors::Basins>& basins,
                                             const PageFrame& frame = {});
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::Basins& basins,
                                             const PageFrame& frame = {});
[[nodiscard]] std::vector<tools::File> pages(const numeric::attractors::Diagram& diagram,
                                             const PageFrame& frame = {});

inline constexpr std::size_t most_pictured = 24;

}  // namespace stickslip::report::orbits
