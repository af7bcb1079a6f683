// Is a result still the same: two audits' JSON, an older and a newer one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/tools/json.hpp"

namespace stickslip::report::audit {

// A text, a verdict or a number that is not the same. A number is the same if the two balls meet, as balls
// about one number do.
struct Difference {
  std::string id;    // of the statement or the claim, or "S, orbit 2"
  std::string what;  // "status", "what is printed", "tau", ...
  std::string before, now;
};

struct Comparison {
  std::string program;   // that made the older one, with its version
  std::size_t same = 0;  // statements, claims and orbits of examples without a difference
  std::vector<Difference> differences;
  std::vector<std::string> gone, added;  // ids that only the older one has, and only the newer one
  [[nodiscard]] bool is_same() const { return differences.empty() && gone.empty(); }
};

// The JSON of an audit in a file. Throws InputOutputError where it cannot be read, UsageError naming it where
// it is no such JSON or its schema_version has another first number than this program's.
[[nodiscard]] tools::Json read_audit(const std::string& file);

// Statements by their status and claims; claims by their status, what is printed and assumed, the theorems
// that answer them with all hypotheses, and the proved numbers beside printed ones; the orbits of examples by
// how many there are, their numbers, stability and conditions. Words about them are not compared.
[[nodiscard]] Comparison compare(const tools::Json& older, const tools::Json& newer);

// A line for each difference, and a sentence.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace stickslip::report::audit
