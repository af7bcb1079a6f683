// The orbits of the paper's three examples, for its report.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "numeric/examples.hpp"
#include "numeric/orbits.hpp"

namespace stickslip::report {

struct ExampleOrbits {
  Example example;
  OrbitList list;
};

// What is asked for all orbits at the data of the example.
[[nodiscard]] OrbitQuestion question_of(const Example& example);

// The complete lists of orbits at the data of Figs. 2, 3 and 4.
[[nodiscard]] std::vector<ExampleOrbits> example_orbits();

// The orbit whose values are nearest to those that the paper prints, the largest relative difference
// deciding: the one that the figure shows. None when there is no orbit.
[[nodiscard]] std::optional<std::size_t> printed_orbit(const ExampleOrbits& example);

}  // namespace stickslip::report
