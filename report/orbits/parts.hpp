// The parts of an orbit that all of its reports share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/orbits.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

namespace stickslip::report::orbits {

// {"mid", "rad"} with as many digits as are worth it, at most so many.
[[nodiscard]] tools::Json to_json(const Ball& value, int digits);
// Each under its name.
void add_values(tools::Json& json, const std::vector<numeric::NamedBall>& values, int digits);
// {"id", "statement", "verdict", "reason", "margin", "at"}.
[[nodiscard]] tools::Json to_json(const numeric::motion::Condition& condition);
// true, false, or null when it is neither proved nor refuted.
[[nodiscard]] tools::Json to_json(const Verdict& admissible);
// "multipliers", "stability", "stability_reason", if it is known.
void add_stability(tools::Json& json, const std::optional<numeric::motion::Stability>& stability, int digits);

// For a terminal: the escape sequences, empty without colours; lines that begin with two spaces.
[[nodiscard]] std::string bold(const tools::Style& style);
[[nodiscard]] std::string colour_of(Truth truth, const tools::Style& style);
[[nodiscard]] std::string stability_rows(const std::optional<numeric::motion::Stability>& stability,
                                         int digits, const tools::Style& style);
[[nodiscard]] std::string condition_rows(const std::vector<numeric::motion::Condition>& conditions,
                                         const tools::Style& style);

}  // namespace stickslip::report::orbits
