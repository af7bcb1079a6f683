// The words that every form of a list of orbits shares.
#pragma once

#include <string>
#include <vector>

#include "numeric/orbits.hpp"

namespace stickslip::report {

// "symmetric", "overshooting", "nonsticking".
[[nodiscard]] std::string name_of(Family family);

// The exact notation of a parameter: "0.5", or "0.5+-0.0001" for an interval.
[[nodiscard]] std::string notation(const Range& range);

struct NamedRange {
  std::string name;
  Range range;
};

// The six parameters in the paper's order, then phi and ur as far as they are given.
[[nodiscard]] std::vector<NamedRange> named_parameters(const OrbitQuestion& question);

// The colour of a kind of phase in pictures: "#1f4e9c".
[[nodiscard]] std::string colour_of(PhaseKind kind);

// One sentence.
[[nodiscard]] std::string describe(Remark remark);

}  // namespace stickslip::report
