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
  std::vector<Sample> samples;
  const Record record =
      record_motion(s, {200, 0.3}, always, [&](const Sample& sample) { samples.push_back(sample); });
  const Run run = follow(s, 200);
  CHECK(record.samples == 668);
  REQUIRE(samples.size() == 668);
  CHECK(samples[7].time == doctest::Approx(2.1).epsilon(1e-14));
  CHECK(samples.back().time == doctest::Approx(200).epsilon(1e-14));
  CHECK((record.end.X - run.end).lpNorm<Eigen::Infinity>() < 1e-9);
  CHECK(record.events == static_cast<long>(run.transitions.size()));
  CHECK(record.time_in[0] + record.time_in[1] + record.time_in[2] == doctest::Approx(200).epsilon(1e-12));
  REQUIRE(record.events > static_cast<long>(2 * Record::shown));
  CHECK(record.first_events.front().time == doctest::Approx(run.transitions.front().time));
  CHECK(record.last_events.back().time == doctest::Approx(run.transitions.back().time));
  REQUIRE(record.energy);
  for (const Sample& sample : samples) {
    CHECK(sample.energy >= record.energy->least);
    CHECK(sample.energy <= record.energy->greatest);
    CHECK(std::abs(sample.u) <= s.ur);
  }
}

TEST_CASE("a record without samples has the same events, shares and end") {
  const Record with = record_motion(lively(), {200, 0.3}, always);
  const Record without = record_motion(lively(), {200, std::nullopt}, always);
  CHECK(without.samples == 0);
  CHECK_FALSE(without.energy);
  CHECK(without.done == doctest::Approx(200).epsilon(1e-14));
  CHECK(without.events == with.events);
  CHECK(without.last_events.back().time == doctest::Approx(with.last_events.back().time).epsilon(1e-12));
  CHECK((without.end.X - with.end.X).lpNorm<Eigen::Infinity>() < 1e-9);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(without.time_in[k] == doctest::Approx(with.time_in[k]).epsilon(1e-12));
  }
}

TEST_CASE("an interrupted record says how far it came") {
  const Record record =
      record_motion(lively(), {1e6, std::nullopt}, [](double share) { return share < 0.01; });
  CHECK(record.interrupted);
  CHECK(record.done >= 1e4);
  CHECK(record.done < 1e5);
  CHECK(record.samples == 0);
  CHECK(record.end.time == doctest::Approx(record.done));
  const Record rare = record_motion(lively(), {1e6, 1e6}, [](double) { return false; });
  CHECK(rare.done < 3e4);
  CHECK(rare.samples == 2);
}

TEST_CASE("plans that make no sense are refused") {
  CHECK_THROWS_AS((void)record_motion(lively(), {0, 1}, always), DomainError);
  CHECK_THROWS_AS((void)record_motion(lively(), {1, 0}, always), DomainError);
  CHECK_THROWS_AS((void)record_motion(lively(), {1e12, 1e-6}, always), DomainError);
}

TEST_CASE("the record of any oscillator is that of the paper's for its data") {
  const Start s = lively();
  const Record paper = record_motion(s, {50, 0.5}, always);
  std::vector<SampleOf<AnyState>> samples;
  const auto any =
      record_motion(model::friction_oscillator<double>(s.data, s.ur), s.phi, AnyState(s.X), {50, 0.5}, always,
                    [&](const SampleOf<AnyState>& sample) { samples.push_back(sample); });
  CHECK(any.events == paper.events);
  CHECK(any.samples == paper.samples);
  CHECK(samples.size() == static_cast<std::size_t>(paper.samples));
  CHECK(any.period == doctest::Approx(paper.period));
  CHECK((any.end.X - paper.end.X).lpNorm<Eigen::Infinity>() < 1e-8);
  CHECK(any.end.energy == doctest::Approx(paper.end.energy));
  CHECK(any.energy->least == doctest::Approx(paper.energy->least));
  CHECK(any.energy->greatest == doctest::Approx(paper.energy->greatest));
  CHECK(any.time_in[2] == doctest::Approx(paper.time_in[2]));
}
