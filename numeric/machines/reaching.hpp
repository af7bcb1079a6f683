// Which of some neighbourhoods of stable orbits motions are proved to reach.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "numeric/machines/neighbourhood.hpp"

namespace stickslip::numeric::machines {

// Pixels of a plane: `starts` are their middles, row by row, at load phase 0; in two of the coordinates they
// are so wide to each side.
struct Pixels {
  std::vector<Eigen::VectorXd> starts;
  std::array<int, 2> across;
  std::array<double, 2> half;
  std::array<long, 2> count;  // columns and rows
};
// Which neighbourhood all motions from each pixel reach, as far as that is proved: of some pixels together
// where that succeeds, else of the halves.
[[nodiscard]] std::vector<std::optional<std::size_t>> reached(
    const Machine& machine, const Pixels& pixels, std::vector<std::shared_ptr<const Neighbourhood>> all);

}  // namespace stickslip::numeric::machines
