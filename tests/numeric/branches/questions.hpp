// Questions about branches of the paper's examples, for the tests.
#pragma once

#include "numeric/branches/setting.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::branches::examples {

[[nodiscard]] inline OrbitQuestion data(const char * family, const std::array<const char *, 6>& values) {
  const auto range = [&](std::size_t k) { return Range{parse_rational(values[k])}; };
  return {&family_named(family), {range(0), range(1), range(2), range(3), range(4), range(5)}, {}, {}, 20};
}
[[nodiscard]] inline OrbitQuestion S() {
  return data("symmetric", {"0.5", "3.8", "0.02", "1", "0.6", "0.05"});
}
[[nodiscard]] inline OrbitQuestion O() {
  OrbitQuestion q = data("overshooting", {"0.2", "4", "0.05", "1", "0.6289", "0.05"});
  q.phi = Range{0};
  return q;
}
[[nodiscard]] inline OrbitQuestion P() {
  return data("nonsticking", {"0.3", "4", "0.1", "0.1", "0.6", "1"});
}

[[nodiscard]] inline BranchQuestion along(OrbitQuestion orbits, const char * parameter, const char * from,
                                          const char * to) {
  return {std::move(orbits), parameter, parse_rational(from), parse_rational(to), {}};
}

// The orbits with the parameter at that value, proved, and the curve of each.
struct Start {
  Curve curve;
  Point point;
};
[[nodiscard]] inline std::vector<Start> starts(const BranchQuestion& question, const Rational& value) {
  std::vector<Start> all;
  for (const families::Candidate& found :
       question.orbits.family->search(data_at(question, value)).candidates) {
    const Curve curve = curve_of(question, found.equations);
    const ProvedPoint point = prove_at(curve, value, found.equations.unknowns(found.guess));
    if (point.verdict.truth == Truth::proved) {
      all.push_back({curve, point.point});
    }
  }
  return all;
}

}  // namespace stickslip::numeric::branches::examples
