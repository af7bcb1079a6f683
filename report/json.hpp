// An audit as JSON: the published form of the results, and the data that the pages are made from.
#pragma once

#include <nlohmann/json.hpp>

#include "proofs/claim.hpp"

namespace stickslip::report {

using Json = nlohmann::ordered_json;

// Version of the layout below: a new number in front when something is renamed or removed, behind when added.
inline constexpr const char* schema_version = "1.0";

// {"schema_version", "program": {"name", "version"}, "libraries": [{"name", "version"}],
//  "paper": {"author", "title", "journal", "doi"},
//  "summary": {"statements", "decided", "line", "statuses": [{"status", "meaning", "count"}]},
//  "places": [{"id", "title", "claims": [CLAIM]}]}
// CLAIM: {"id", "place", "kind", "words", "status", "meaning", "finding",
//  "printed": [FORMULA], "corrected": [FORMULA], "assumptions": [{"id", "latex", "text", "needed"}],
//  "outcome": OUTCOME, "corrected_outcome": OUTCOME or null, "converse": OUTCOME or null,
//  "repairs": [{"what", "latex", "text"}], "illegible", "used_by": [id]}
// FORMULA: {"latex", "text"}
// OUTCOME: {"verdict", "reason", "witness": null or {"point": [{"name", "latex", "value"}], "component",
// "left": BALL,
//  "right": BALL}, "route", "hypotheses": [{"latex", "text", "origin"}], "uses": [id], "free": [{"name",
//  "latex"}], "comparisons": [{"name", "latex", "printed", "proved": BALL, "units_off": BALL, "verdict",
//  "reason"}]}
// BALL: {"mid", "rad"}, decimal strings, rounded outwards.
//
// Every key is always there; numbers are strings except for counts; the same audit gives the same text,
// always.
[[nodiscard]] Json to_json(const proofs::Audit& audit);

// As it stands in audit.json: indented, ending with a line feed.
[[nodiscard]] std::string to_text(const Json& json);

}  // namespace stickslip::report
