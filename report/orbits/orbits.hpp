// Lists of orbits for readers and for programs.
#pragma once

#include <string>

#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// What a list is as JSON, to the digits asked for; its schema. Keys that do not apply are absent,
// "admissible" is null when undecided.
void write_orbits(tools::Object& json, const numeric::OrbitList& list);
[[nodiscard]] tools::Json to_json(const numeric::OrbitList& list);
[[nodiscard]] tools::File orbits_schema();

// Which orbits are described in full: those that may be admissible, or all.
enum class InFull { admissible, all };

// The parameters; how complete the search is; each orbit with its values to the asked digits and its
// conditions, admissible ones first; formal solutions, which are not admissible, in a line each unless all
// are asked for in full. An orbit keeps its number in the list. Parameters and conditions are those of (2) in
// any units. No line is longer than the width of the style, except for what cannot be broken.
[[nodiscard]] std::string terminal_report(const numeric::OrbitList& list, const tools::Style& style,
                                          const Units& units = {}, InFull in_full = InFull::admissible);

}  // namespace stickslip::report::orbits

template <>
struct stickslip::report::tools::SampleOf<stickslip::numeric::OrbitList> {
  [[nodiscard]] static numeric::OrbitList made() {
    numeric::OrbitList list;
    list.question.family = numeric::all_families().front();
    return list;
  }
};
