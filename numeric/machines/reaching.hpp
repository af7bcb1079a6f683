// Which of some neighbourhoods of stable orbits motions are proved to reach.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "numeric/machines/neighbourhood.hpp"

namespace stickslip::numeric::machines {

class Reaching {
 public:
  // At the working precision; those that are not proved are reached by none.
  Reaching(const Machine& machine, std::vector<std::shared_ptr<const Neighbourhood>> all);

  // That which all motions from middle + S e at load phase 0, |e_k| <= 1, are proved to reach within so many
  // periods of the load, or of the orbits; nothing if they are not.
  [[nodiscard]] std::optional<std::size_t> operator()(const Vector& middle, const Matrix& S,
                                                      long most_periods = 30);

 private:
  [[nodiscard]] std::optional<std::size_t> in_periods(SetOfMotions set, long most_periods);
  [[nodiscard]] std::optional<std::size_t> at_events(SetOfMotions set, long most_periods) const;

  SetFlow flow_;
  simulation::AnySimulation simulation_;
  bool autonomous_;
  std::vector<std::shared_ptr<const Neighbourhood>> all_;
};

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
