#include "numeric/simulation/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/energy.hpp"

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

void add_sample(Record& record, const Sample& sample, bool keep) {
  record.least_energy = std::min(record.least_energy, sample.energy);
  record.greatest_energy = std::max(record.greatest_energy, sample.energy);
  record.end = sample;
  if (keep) {
    record.samples.push_back(sample);
  }
}

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
  if (!(plan.every > 0) || !(plan.duration / plan.every <= most_samples)) {
    throw DomainError("every", fmt::format("{}", plan.every),
                      fmt::format("every > 0, at most {:.0g} samples", most_samples));
  }
}

}  // namespace

Record record_motion(const Start& start, const RecordPlan& plan, const std::function<bool(double)>& go_on) {
  Simulation simulation(start.data, start.ur, start.phi, start.X);
  require_plan(plan);
  Record record;
  record.start = start;
  record.period = simulation.period();
  const Sample first = sample_of(simulation);
  record.least_energy = record.greatest_energy = first.energy;
  add_sample(record, first, plan.keep_samples);
  std::vector<Transition> events;
  const long count = std::max(1L, std::lround(std::ceil(plan.duration / plan.every * (1 - 1e-12))));
  for (long k = 1; k <= count && !record.interrupted; ++k) {
    const double until = std::min(plan.duration, static_cast<double>(k) * plan.every);
    double left = until - record.done;
    while (left > 0 && !record.interrupted) {
      events.clear();
      left = simulation.advance(left, &events, steps_between_questions);
      add_events(record, events);
      record.done = until - left;
      record.interrupted = record.done < plan.duration && !go_on(record.done / plan.duration);
    }
    add_sample(record, sample_of(simulation), plan.keep_samples);
  }
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    record.time_in[static_cast<std::size_t>(kind)] = simulation.time_in(kind);
  }
  return record;
}

}  // namespace stickslip::numeric::simulation
