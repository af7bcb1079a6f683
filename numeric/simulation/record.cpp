#include "numeric/simulation/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/energy.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;

namespace {

constexpr double most_samples = 1e9;
constexpr long steps_between_questions = 30000;

Sample sample_of(const Simulation& s) {
  const model::Vector4<double> X = s.state();
  return {s.time(),
          s.phase(),
          X,
          s.friction_at_rest(),
          s.friction(),
          model::energy<double>(s.data().chi, s.data().eta, X)};
}

// Hands the samples on and remembers the extremes of their energy.
class Sampler {
 public:
  Sampler(Record& record, const std::function<void(const Sample&)>& take) : record_(record), take_(take) {}

  void operator()(const Sample& sample) {
    ++record_.samples;
    Extremes& energy =
        record_.energy ? *record_.energy : record_.energy.emplace(sample.energy, sample.energy);
    energy.least = std::min(energy.least, sample.energy);
    energy.greatest = std::max(energy.greatest, sample.energy);
    if (take_) {
      take_(sample);
    }
  }

 private:
  Record& record_;
  const std::function<void(const Sample&)>& take_;
};

void add_events(Record& record, const std::vector<Transition>& events) {
  for (const Transition& event : events) {
    ++record.events;
    if (record.first_events.size() < Record::shown) {
      record.first_events.push_back(event);
      continue;
    }
    record.last_events.push_back(event);
    if (record.last_events.size() > Record::shown) {
      record.last_events.erase(record.last_events.begin());
    }
  }
}

void require_plan(const RecordPlan& plan) {
  if (!(plan.duration > 0) || !std::isfinite(plan.duration)) {
    throw DomainError("the duration", fmt::format("{}", plan.duration), "a finite number > 0");
  }
  if (plan.every && (!(*plan.every > 0) || !(plan.duration / *plan.every <= most_samples))) {
    throw DomainError("every", fmt::format("{}", *plan.every),
                      fmt::format("every > 0, at most {:.0g} samples", most_samples));
  }
}

}  // namespace

Record record_motion(const Start& start, const RecordPlan& plan, const std::function<bool(double)>& go_on,
                     const std::function<void(const Sample&)>& take) {
  if (start.ur <= start.data.us) {
    throw DomainError("ur", fmt::format("{}", start.ur), fmt::format("ur > us = {}", start.data.us));
  }
  Simulation simulation(start.data, start.ur, start.phi, start.X);
  require_plan(plan);
  Record record;
  record.start = start;
  record.period = simulation.period();
  Sampler sampler(record, take);
  if (plan.every) {
    sampler(sample_of(simulation));
  }
  const double every = plan.every.value_or(plan.duration);
  std::vector<Transition> events;
  const long count = std::max(1L, std::lround(std::ceil(plan.duration / every * (1 - 1e-12))));
  for (long k = 1; k <= count && !record.interrupted; ++k) {
    const double until = std::min(plan.duration, static_cast<double>(k) * every);
    double left = until - record.done;
    while (left > 0 && !record.interrupted) {
      events.clear();
      left = simulation.advance(left, &events, steps_between_questions);
      add_events(record, events);
      record.done = until - left;
      record.interrupted = record.done < plan.duration && !go_on(record.done / plan.duration);
    }
    if (plan.every) {
      sampler(sample_of(simulation));
    }
  }
  record.end = sample_of(simulation);
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    record.time_in[static_cast<std::size_t>(kind)] = simulation.time_in(kind);
  }
  return record;
}

}  // namespace stickslip::numeric::simulation
