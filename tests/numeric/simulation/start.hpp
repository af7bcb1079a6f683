// Starts of motions, and the closed form against the raw law.
#pragma once

#include <doctest/doctest.h>

#include <random>
#include <vector>

#include "numeric/simulation/agreement.hpp"

namespace stickslip::dynamics_tests {

using namespace numeric::simulation;

// Data like example O's with a strong load: slips, overshoots and sticks.
[[nodiscard]] inline Start lively() {
  return {{0.3, 2.0, 0.1, 0.5, 0.7, 0.6}, 0.25, 0.3, {0.4, 0.9, 0.1, 0.2}};
}

[[nodiscard]] inline double uniform(std::mt19937& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

[[nodiscard]] inline Start random_start(std::mt19937& random) {
  Start s;
  s.data = {uniform(random, 0.05, 0.95), uniform(random, 0.3, 5), uniform(random, 0.02, 0.3),
            uniform(random, -0.5, 1),    uniform(random, 0.2, 2), uniform(random, 0, 1)};
  s.ur = s.data.us * uniform(random, 1, 4);
  s.phi = uniform(random, -3, 3);
  for (int i = 0; i < 4; ++i) {
    s.X(i) = uniform(random, -1, 1);
  }
  if (random() % 2 == 0) {
    s.X(3) = s.data.V;
  }
  return s;
}

[[nodiscard]] inline bool is_finite(const Run& run) {
  return run.end.array().isFinite().all();
}

// The same events at the same times, the same end.
inline void check_same(const Run& a, const Run& b, double accuracy) {
  REQUIRE(a.transitions.size() == b.transitions.size());
  for (std::size_t k = 0; k < a.transitions.size(); ++k) {
    CHECK(a.transitions[k].after == b.transitions[k].after);
    CHECK(std::abs(a.transitions[k].time - b.transitions[k].time) < accuracy);
  }
  CHECK((a.end - b.end).lpNorm<Eigen::Infinity>() < accuracy);
}

// The closed form and the raw law.
[[nodiscard]] inline const std::vector<Follow>& both_ways() {
  static const std::vector<Follow> ways{
      follow, [](const Start& start, double duration) { return follow_raw_law(start, duration); }};
  return ways;
}

inline void check_against_raw_law(const Start& start, double duration, double accuracy) {
  const Run closed = follow(start, duration);
  CHECK(is_finite(closed));
  check_same(closed, follow_raw_law(start, duration), accuracy);
}

}  // namespace stickslip::dynamics_tests
