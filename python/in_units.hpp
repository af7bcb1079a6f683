// Results with their times, lengths, velocities and forces in other units: to be told, for their data are
// left as they are.
#pragma once

#include "numeric/attractors/diagram.hpp"
#include "numeric/attractors/word_search.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/simulation.hpp"

namespace stickslip::python {

using report::orbits::Units;

// Enough for the factor of a unit to take none of the digits asked for.
[[nodiscard]] long bits_for(int digits);

// Values and durations; those of motions and states; states once a period, along a value of a machine in SI
// units always in SI; starts; record and what it settles on. Balls are rounded outwards.
[[nodiscard]] numeric::attractors::WordOrbits in_units(numeric::attractors::WordOrbits list,
                                                       const Units& units);
[[nodiscard]] numeric::attractors::AttractorList in_units(numeric::attractors::AttractorList list,
                                                          const Units& units);
[[nodiscard]] numeric::attractors::Diagram in_units(numeric::attractors::Diagram diagram, const Units& units);
[[nodiscard]] numeric::attractors::Basins in_units(numeric::attractors::Basins basins, const Units& units);
[[nodiscard]] report::orbits::Simulated in_units(report::orbits::Simulated simulated, const Units& units);

}  // namespace stickslip::python
