// An orbit as the user names it: FAMILY:K.
#pragma once

#include <cstddef>
#include <string>

#include "cli/machine_file.hpp"
#include "numeric/orbits.hpp"
#include "proofs/methods/paper.hpp"

namespace stickslip::cli {

struct NamedOrbit {
  numeric::OrbitList list;  // that it is in
  std::size_t index = 0;    // from 0

  [[nodiscard]] const numeric::Orbit& orbit() const { return list.orbits[index]; }
};

// Orbit K, from 1, of those that `stickslip orbits FAMILY` lists at the parameters, of which the family's
// results are left out. Searches for the orbits. Throws UsageError for what is no such name, for a missing
// parameter, for an interval and for an orbit that there is not, DomainError as list_orbits does.
[[nodiscard]] NamedOrbit named_orbit(const std::string& name, const proofs::methods::Paper& paper,
                                     ParameterFile& file, int digits);

}  // namespace stickslip::cli
