// The orbits that a paper's examples speak of, proved.
#pragma once

#include <cstddef>
#include <optional>

#include "numeric/orbits.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::methods {

// What `orbits` is asked for the data of the example.
[[nodiscard]] numeric::OrbitQuestion question_of(const Example& example, int digits = 20);

// An example and the complete list of orbits at its data.
struct ExampleOrbits {
  Example example;
  numeric::OrbitList list;
};

// The list at the example's data to 30 digits; made once, when it is first asked for.
[[nodiscard]] const ExampleOrbits& orbits_of(const Example& example);

// The orbit whose values are nearest to the printed ones, the largest relative difference deciding: the one
// that the figure shows. None when the list is empty.
[[nodiscard]] std::optional<std::size_t> printed_orbit(const ExampleOrbits& orbits);

// That orbit of orbits_of(example). Throws InternalError when there is none.
[[nodiscard]] const numeric::Orbit& printed_orbit(const Example& example);

}  // namespace stickslip::proofs::methods
