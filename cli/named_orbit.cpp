#include "cli/named_orbit.hpp"

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/orbit_data.hpp"
#include "core/error.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::cli {

using namespace numeric;

NamedOrbit named_orbit(const std::string& name, const proofs::methods::Paper& paper, ParameterFile& file,
                       int digits) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos || colon + 1 == name.size()) {
    throw UsageError(
        fmt::format("orbit: '{}' is not FAMILY:K, such as {}:1", name, all_families().front()->name));
  }
  const Family& family = family_named(name.substr(0, colon));
  const auto number =
      static_cast<std::size_t>(whole_number("orbit", name.substr(colon + 1), OrbitsOptions::most_orbits));
  leave_results_out(file, family);
  const OrbitQuestion asked = question(paper, family, file, digits);
  if (asks_for_box(asked)) {
    throw UsageError(fmt::format("the orbit {} needs numbers, but a parameter is an interval", name));
  }
  NamedOrbit found{list_orbits(asked), number - 1};
  const std::size_t count = found.list.orbits.size();
  if (number > count) {
    throw UsageError(fmt::format("there is no orbit {}: {} {} in the list of stickslip orbits {}", name,
                                 count, count == 1 ? "is" : "are", family.name));
  }
  return found;
}

}  // namespace stickslip::cli
