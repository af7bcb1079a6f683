// The closed form against the raw law on random data. The number of periods is 200, or that of the
// environment variable STICKSLIP_RANDOM_PERIODS.
#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "tests/numeric/simulation/start.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::simulation;
using namespace stickslip::dynamics_tests;

namespace {

constexpr int periods_per_run = 5;
constexpr double accuracy = 1e-6;

// Nothing when the events are the same at the same times.
std::optional<std::size_t> first_difference(const Run& a, const Run& b) {
  const std::size_t count = std::max(a.transitions.size(), b.transitions.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (k >= a.transitions.size() || k >= b.transitions.size() ||
        a.transitions[k].after != b.transitions[k].after ||
        std::abs(a.transitions[k].time - b.transitions[k].time) > accuracy) {
      return k;
    }
  }
  return std::nullopt;
}

// An event that a trifle would have changed: the belt is touched almost without acceleration, or |r| is at
// its threshold when it is touched.
bool is_delicate(const Start& s, const Transition& t) {
  constexpr double trifle = 1e-4;
  const double r = std::abs(t.r);
  const double acceleration = std::min(std::abs(t.r - s.data.us), std::abs(t.r + s.data.us));
  return (t.before != PhaseKind::stick && (acceleration < trifle || std::abs(r - s.ur) < trifle));
}

struct Tally {
  int same = 0, delicate = 0, unexplained = 0;
};

void compare(const Start& s, double duration, Tally& tally) {
  const Run closed = follow(s, duration);
  REQUIRE(is_finite(closed));
  const Run raw = follow_raw_law(s, duration);
  const auto k = first_difference(closed, raw);
  if (!k) {
    ++tally.same;
    return;
  }
  for (std::size_t i = *k > 0 ? *k - 1 : 0; i <= *k; ++i) {
    for (const Run * run : {&closed, &raw}) {
      if (i < run->transitions.size() && is_delicate(s, run->transitions[i])) {
        ++tally.delicate;
        return;
      }
    }
  }
  ++tally.unexplained;
  MESSAGE("unexplained: chi " << s.data.chi << " eta " << s.data.eta << " us " << s.data.us << " V "
                              << s.data.V << " omega " << s.data.omega << " p " << s.data.p << " ur " << s.ur
                              << " phi " << s.phi << " X " << s.X.transpose() << " event " << *k);
}

}  // namespace

TEST_CASE("every difference between the closed form and the raw law is explained") {
  const char * wanted = std::getenv("STICKSLIP_RANDOM_PERIODS");
  const int periods = wanted == nullptr ? 200 : std::stoi(wanted);
  std::mt19937 random(4);
  Tally tally;
  for (int k = 0; k < periods; k += periods_per_run) {
    const Start s = random_start(random);
    compare(s, periods_per_run * 2 * std::acos(-1.0) / s.data.omega, tally);
  }
  MESSAGE("runs of " << periods_per_run << " periods: same " << tally.same << ", delicate " << tally.delicate
                     << ", unexplained " << tally.unexplained);
  CHECK(tally.unexplained == 0);
  CHECK(tally.same > 9 * tally.delicate);
}
