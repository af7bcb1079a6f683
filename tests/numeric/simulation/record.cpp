// Records of simulated motions.
#include "numeric/simulation/record.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/error.hpp"
#include "tests/numeric/simulation/start.hpp"

using namespace stickslip;
using namespace stickslip::numeric::simulation;
using namespace stickslip::dynamics_tests;

namespace {

constexpr auto always = [](double) { return true; };

}  // namespace

TEST_CASE("a record has its samples at the asked times, all events, and shares that add up") {
  const Start s = lively();
  const Record record = record_motion(s, {200, 0.3, true}, always);
  const Run run = follow(s, 200);
  CHECK(record.samples.size() == 668);
  CHECK(record.samples[7].time == doctest::Approx(2.1).epsilon(1e-14));
  CHECK(record.samples.back().time == doctest::Approx(200).epsilon(1e-14));
  CHECK((record.end.X - run.end).lpNorm<Eigen::Infinity>() < 1e-9);
  CHECK(record.events == static_cast<long>(run.transitions.size()));
  CHECK(record.time_in[0] + record.time_in[1] + record.time_in[2] == doctest::Approx(200).epsilon(1e-12));
  REQUIRE(record.events > static_cast<long>(2 * Record::shown));
  CHECK(record.first_events.front().time == doctest::Approx(run.transitions.front().time));
  CHECK(record.last_events.back().time == doctest::Approx(run.transitions.back().time));
  for (const Sample& sample : record.samples) {
    CHECK(sample.energy >= record.least_energy);
    CHECK(sample.energy <= record.greatest_energy);
    CHECK(std::abs(sample.u) <= s.ur);
  }
}

TEST_CASE("an interrupted record says how far it came") {
  const Record record = record_motion(lively(), {1e6, 1, false}, [](double share) { return share < 0.01; });
  CHECK(record.interrupted);
  CHECK(record.done >= 1e4);
  CHECK(record.done < 2e4);
  CHECK(record.samples.empty());
  CHECK(record.end.time == doctest::Approx(record.done));
  const Record rare = record_motion(lively(), {1e6, 1e6, true}, [](double) { return false; });
  CHECK(rare.done < 2e4);
  CHECK(rare.samples.size() == 2);
}

TEST_CASE("plans that make no sense are refused") {
  CHECK_THROWS_AS((void)record_motion(lively(), {0, 1}, always), DomainError);
  CHECK_THROWS_AS((void)record_motion(lively(), {1, 0}, always), DomainError);
  CHECK_THROWS_AS((void)record_motion(lively(), {1e12, 1e-6}, always), DomainError);
}
