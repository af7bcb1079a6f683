#include "numeric/simulation/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain.hpp"
#include "model/parameters.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;

namespace {

constexpr double most_samples = 1e9;
constexpr long steps_between_questions = 30000;

void add_event(auto& record, const auto& event) {
  ++record.events;
  if (record.first_events.size() < record.shown) {
    record.first_events.push_back(event);
    return;
  }
  record.last_events.push_back(event);
  if (record.last_events.size() > record.shown) {
    record.last_events.erase(record.last_events.begin());
  }
}

void require_plan(const RecordPlan& plan) {
  require(plan.duration > 0 && std::isfinite(plan.duration), "the duration", plan.duration,
          "a finite number > 0");
  const double every = plan.every.value_or(plan.duration);
  require(every > 0 && plan.duration / every <= most_samples, "every", every,
          fmt::format("every > 0, at most {:.0g} samples", most_samples));
}

// The record but for what it starts from; `energy` of a state.
template <class Simulation, class Record, class Energy, class Take>
void follow(Simulation& simulation, Record& record, const RecordPlan& plan, const Energy& energy,
            const std::function<bool(double)>& go_on, const Take& take) {
  require_plan(plan);
  record.period = simulation.period();
  const auto sample_of = [&] {
    return decltype(record.end){simulation.time(),     simulation.phase(),
                                simulation.state(),    simulation.friction_at_rest(),
                                simulation.friction(), energy(simulation.state())};
  };
  const auto sample = [&] {
    if (!plan.every) {
      return;
    }
    const auto now = sample_of();
    ++record.samples;
    Extremes& e = record.energy ? *record.energy : record.energy.emplace(Extremes{now.energy, now.energy});
    e = {std::min(e.least, now.energy), std::max(e.greatest, now.energy)};
    if (take) {
      take(now);
    }
  };
  sample();
  const double every = plan.every.value_or(plan.duration);
  std::vector<typename Simulation::Transition> events;
  const long count = std::max(1L, std::lround(std::ceil(plan.duration / every * (1 - 1e-12))));
  for (long k = 1; k <= count && !record.interrupted; ++k) {
    const double until = std::min(plan.duration, static_cast<double>(k) * every);
    double left = until - record.done;
    while (left > 0 && !record.interrupted) {
      events.clear();
      left = simulation.advance(left, &events, steps_between_questions);
      for (const auto& event : events) {
        add_event(record, event);
      }
      record.done = until - left;
      record.interrupted = record.done < plan.duration && !go_on(record.done / plan.duration);
    }
    sample();
  }
  record.end = sample_of();
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    record.time_in[static_cast<std::size_t>(kind)] = simulation.time_in(kind);
  }
}

}  // namespace

Record record_motion(const Start& start, const RecordPlan& plan, const std::function<bool(double)>& go_on,
                     const std::function<void(const Sample&)>& take) {
  require(!(start.ur <= start.data.us), "ur", start.ur, fmt::format("ur > us = {}", start.data.us));
  Simulation simulation(start.data, start.ur, start.phi, start.X);
  Record record;
  record.start = start;
  follow(
      simulation, record, plan,
      [&](const model::Vector4<double>& X) {
        return model::energy<double>(start.data.chi, start.data.eta, X);
      },
      go_on, take);
  return record;
}

RecordOf<AnyState> record_motion(const model::FrictionOscillator<double>& oscillator, double phi,
                                 const AnyState& X, const RecordPlan& plan,
                                 const std::function<bool(double)>& go_on,
                                 const std::function<void(const SampleOf<AnyState>&)>& take) {
  AnySimulation simulation(oscillator, phi, X);
  RecordOf<AnyState> record;
  follow(
      simulation, record, plan,
      [&](const AnyState& state) { return model::energy<double>(oscillator, state); }, go_on, take);
  return record;
}

}  // namespace stickslip::numeric::simulation
