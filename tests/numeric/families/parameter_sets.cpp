// Complete lists, every condition decided, at data of many kinds beside the paper's.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/decimal.hpp"
#include "numeric/orbits.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::motion;

namespace {

struct Set {
  const char * kind;
  const char * family;
  std::array<const char *, 6> data;  // chi, eta, us, V, omega, p
  const char * phi;
  const char * ur;
  std::size_t orbits, admissible;
};

const std::vector<Set> sets = {
    {"S", "symmetric", {"0.5", "3.8", "0.02", "1", "0.6", "0.05"}, nullptr, nullptr, 4, 4},
    {"none above omega2", "symmetric", {"0.5", "3.8", "0.02", "1", "3", "0.05"}, nullptr, nullptr, 0, 0},
    {"all with ur < us", "symmetric", {"0.5", "3.8", "0.02", "1", "0.7", "0.05"}, nullptr, nullptr, 2, 0},
    {"some do not hold the stick",
     "symmetric",
     {"0.5", "3.8", "0.02", "1", "0.45", "0.05"},
     nullptr,
     nullptr,
     4,
     2},
    {"one of either load phase",
     "symmetric",
     {"0.3", "2", "0.05", "1", "0.5", "0.2"},
     nullptr,
     nullptr,
     2,
     2},
    {"strong load", "symmetric", {"0.5", "3.8", "0.02", "1", "0.6", "5"}, nullptr, nullptr, 3, 1},
    {"slow load, many", "symmetric", {"0.5", "3.8", "0.02", "1", "0.2", "0.05"}, nullptr, nullptr, 10, 0},
    {"beside omega1 = 1/2",
     "symmetric",
     {"9/13", "169/36", "0.02", "1", "0.5001", "0.05"},
     nullptr,
     nullptr,
     5,
     1},
    {"O", "overshooting", {"0.2", "4", "0.05", "1", "0.6289", "0.05"}, "0", nullptr, 2, 1},
    {"the load turned away", "overshooting", {"0.2", "4", "0.05", "1", "0.6289", "0.05"}, "3", nullptr, 0, 0},
    {"beyond the fold", "overshooting", {"0.2", "4", "0.05", "1", "0.6", "0.05"}, "0", nullptr, 0, 0},
    {"friction known, phase not",
     "overshooting",
     {"0.2", "4", "0.05", "1", "0.65", "0.05"},
     nullptr,
     "0.4",
     2,
     1},
    {"slow load", "overshooting", {"0.5", "3.8", "0.02", "1", "0.3", "0.05"}, "0.5", nullptr, 6, 0},
    {"P, friction near grazing",
     "nonsticking",
     {"0.3", "4", "0.1", "0", "0.6", "1"},
     nullptr,
     "0.29960",
     2,
     1},
    {"P, friction just too large",
     "nonsticking",
     {"0.3", "4", "0.1", "0", "0.6", "1"},
     nullptr,
     "0.2997",
     2,
     0},
    {"a load too small", "nonsticking", {"0.3", "4", "0.1", "0", "0.6", "0.2"}, nullptr, nullptr, 4, 0},
    {"a moving belt", "nonsticking", {"0.3", "4", "0.1", "0.4", "0.6", "1"}, nullptr, nullptr, 2, 1},
    {"a belt too fast", "nonsticking", {"0.3", "4", "0.1", "2", "0.6", "1"}, nullptr, nullptr, 4, 0},
    {"a load too weak for the belt",
     "nonsticking",
     {"9/13", "169/36", "0.02", "0.1", "0.26", "0.05"},
     nullptr,
     nullptr,
     0,
     0},
    {"beside resonance",
     "nonsticking",
     {"9/13", "169/36", "0.02", "0.05", "0.51", "1"},
     nullptr,
     nullptr,
     2,
     1},
};

std::optional<Range> range(const char * text) {
  return text == nullptr ? std::nullopt : std::optional(Range{parse_rational(text)});
}

OrbitQuestion question(const Set& set) {
  const auto value = [&](std::size_t i) { return Range{parse_rational(set.data[i])}; };
  return {&family_named(set.family),
          {value(0), value(1), value(2), value(3), value(4), value(5)},
          range(set.phi),
          range(set.ur)};
}

}  // namespace

TEST_CASE("complete lists with all conditions decided, at twenty sets of parameters") {
  for (const Set& set : sets) {
    CAPTURE(std::string(set.kind));
    const OrbitList list = list_orbits(question(set));
    CHECK(list.complete());
    CHECK(all_decided(list));
    CHECK(list.orbits.size() == set.orbits);
    CHECK(static_cast<std::size_t>(std::count_if(
              list.orbits.begin(), list.orbits.end(),
              [](const Orbit& orbit) { return orbit.admissible.truth == Truth::proved; })) == set.admissible);
    for (const Orbit& orbit : list.orbits) {
      // What is not admissible is refuted by some condition, and along a phase with a time and a ball.
      CHECK((orbit.admissible.truth == Truth::proved || orbit.admissible.truth == Truth::refuted));
      for (const Condition& condition : orbit.conditions) {
        CAPTURE(condition.id);
        if (condition.violation) {
          CHECK(condition.violation->value.is_negative());
        }
      }
      for (const model::Vector4<Ball>& gap : gaps(orbit.motion)) {
        for (int i = 0; i < 4; ++i) {
          CHECK(gap(i).contains_zero());
        }
      }
    }
  }
}
