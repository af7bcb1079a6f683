// Lists of orbits for readers and for programs.
#pragma once

#include <string>

#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// As report/schema/orbits.schema.json says: what provenance() says, and {"family", "parameters": {"chi",
// "eta", "us", "V", "omega", "p", "phi", "ur"}, "complete", "unresolved": [{"tau": BALL, …, "reason"}],
// "remarks": [text], "orbits": [{"tau": BALL, "tau1", "T", "Theta", "phi", "z10", "z20", "zdot10", "x10",
// "x20", "xdot10", "ur" or "ur_max", "admissible", "split", "multipliers": [{"re": BALL, "im": BALL}],
// "stability": "stable", "unstable", "marginal" or "undecided", "stability_reason", "conditions": [{"id",
// "statement", "verdict", "reason", "margin": BALL, "at": BALL}]}]} BALL: {"mid", "rad"}, decimal strings,
// rounded outwards; parameters are exact decimals or fractions.
//
// Keys that do not apply are absent: phi and ur among the parameters unless given, what the family does not
// have, a margin that is not known, the reason of what is proved, remarks when there are none, multipliers
// and stability unless the orbit is admissible, the reason of stable and unstable. "admissible" is null when
// undecided; "split" is then, for a box of parameters, the one to divide first.
[[nodiscard]] tools::Json to_json(const numeric::OrbitList& list);

// Which orbits are described in full: those that may be admissible, or all.
enum class InFull { admissible, all };

// The parameters; how complete the search is; each orbit with its values to the asked digits and its
// conditions, admissible ones first; formal solutions, which are not admissible, in a line each unless all
// are asked for in full. An orbit keeps its number in the list. Parameters and conditions are those of (2) in
// any units. No line is longer than the width of the style, except for what cannot be broken.
[[nodiscard]] std::string terminal_report(const numeric::OrbitList& list, const tools::Style& style,
                                          const Units& units = {}, InFull in_full = InFull::admissible);

}  // namespace stickslip::report::orbits
