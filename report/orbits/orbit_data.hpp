// What the templates see of lists of orbits.
#pragma once

#include "numeric/orbits.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::orbits {

// {"title", "searched", "result", "command", "parameters": [{"latex", "value_latex"}], "remarks": [text],
//  "unresolved": [{"where": [{"latex", "value"}], "reason"}],
//  "orbits": [{"number", "total", "verdict", "tell", "split", "split_latex",
//   "stability": null or {"kind", "reason"}, "multipliers": [text],
//   "values": [{"latex", "mid", "rad", "short"}],
//   "conditions": [{"id", "statement", "verdict", "verdict_words", "margin", "at", "reason_if_open"}]}]}
[[nodiscard]] tools::Json orbit_data(const numeric::OrbitList& list);

}  // namespace stickslip::report::orbits
