// An audit as JSON: the published form of the results, and the data that the pages are made from.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "numeric/example_orbits.hpp"
#include "proofs/claim.hpp"
#include "proofs/mutants.hpp"

namespace stickslip::report {

using Json = nlohmann::ordered_json;

// Version of the layouts of audit.json and orbits.json, which report/schema/ describes: a new number in front
// when something is renamed or removed, behind when added.
inline constexpr const char* schema_version = "1.3";

// What every result says about its origin: {"schema_version", "date": text or null, "program": {"name",
// "version"}, "libraries": [{"name", "version"}], "command"}.
[[nodiscard]] Json provenance(const std::string& command);

// As report/schema/audit.schema.json says. Every key is always there; numbers are decimal strings or balls
// {"mid", "rad"} rounded outwards, except for counts. The same audit gives the same text, always. The
// examples are empty, and the mutants null, unless they were asked for.
[[nodiscard]] Json to_json(const proofs::Audit& audit, const std::string& command = "stickslip audit",
                           const std::vector<ExampleOrbits>& examples = {},
                           const std::optional<proofs::Gate>& gate = {});

// As it stands in audit.json: indented, ending with a line feed.
[[nodiscard]] std::string to_text(const Json& json);

}  // namespace stickslip::report
