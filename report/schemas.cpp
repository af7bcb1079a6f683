#include "report/schemas.hpp"

#include "report/atlas/summary.hpp"
#include "report/audit/json.hpp"
#include "report/machines/results.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/pure_word.hpp"
#include "report/orbits/simulation.hpp"

namespace stickslip::report {

std::vector<tools::File> schemas() {
  std::vector<tools::File> all = atlas::schemas();
  for (const tools::File& schema : machines::schemas()) {
    all.push_back(schema);
  }
  for (const auto& schema : {audit::schema, orbits::orbits_schema, orbits::words_schema, orbits::pure_schema,
                             orbits::branches_schema, orbits::attractors_schema, orbits::simulation_schema}) {
    all.push_back(schema());
  }
  return all;
}

}  // namespace stickslip::report
