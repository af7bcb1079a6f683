#include "numeric/machines/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/interruption.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr double nearness = 1e-9;
// A motion whose events are no farther apart than this has come to rest, or slides steadily.
constexpr double least_size = 1e-6;
constexpr long first_mark = 8;
// Of a motion without a load, between two looks.
constexpr long steps_at_once = 1000;
// So many steps without an event: it slides or sticks for good.
constexpr long most_steps_without_event = 1000000;

using attractors::Kind;
using Transition = Simulation::Transition;

double distance(const Eigen::VectorXd& X, const Eigen::VectorXd& Y) {
  return (X - Y).lpNorm<Eigen::Infinity>() /
         std::max({X.lpNorm<Eigen::Infinity>(), Y.lpNorm<Eigen::Infinity>(), 1e-300});
}

MachineGuess guess_of(const std::vector<Transition>& log, double begin) {
  MachineGuess guess;
  for (const Transition& t : log) {
    if (t.changes()) {
      guess.events.push_back({t.time - begin, t.X, {t.after, t.piece_after}});
    }
  }
  return guess;
}

Settled without_events(const Simulation& simulation) {
  const bool sticks = simulation.phase() == motion::PhaseKind::stick;
  return {sticks ? Kind::stuck : Kind::slides, {}, simulation.state()};
}

Settled with_load(Simulation simulation, long most_periods) {
  Eigen::VectorXd mark = simulation.state();
  long marked = 0;
  for (long k = 1; k <= most_periods && !interrupted(); ++k) {
    simulation.advance(simulation.period());
    const Eigen::VectorXd X = simulation.state();
    if (marked > 0 && distance(X, mark) < nearness) {
      const double begin = simulation.time();
      std::vector<Transition> log;
      for (long i = 0; i < k - marked; ++i) {
        simulation.advance(simulation.period(), &log);
      }
      MachineGuess guess = guess_of(log, begin);
      guess.periods = k - marked;
      guess.duration = static_cast<double>(guess.periods) * simulation.period();
      return guess.events.size() < 2 ? without_events(simulation)
                                     : Settled{Kind::periodic, guess, simulation.state()};
    }
    if (k >= first_mark && (k & (k - 1)) == 0) {
      mark = X;
      marked = k;
    }
  }
  return {Kind::unsettled, {}, simulation.state()};
}

Settled without_load(Simulation simulation, long most_events) {
  std::optional<Transition> mark;
  std::vector<Transition> since, log;
  long events = 0, idle = 0;
  while (events < most_events && !interrupted()) {
    log.clear();
    simulation.advance(1e300, &log, steps_at_once);
    idle = log.empty() ? idle + steps_at_once : 0;
    if (idle >= most_steps_without_event) {
      return without_events(simulation);
    }
    for (const Transition& t : log) {
      if (!t.changes()) {
        continue;
      }
      ++events;
      const bool returns = mark && t.after == mark->after && t.piece_after == mark->piece_after &&
                           t.before == mark->before && distance(t.X, mark->X) < nearness;
      const bool moves = std::any_of(since.begin(), since.end(), [&](const Transition& other) {
        return distance(other.X, mark->X) > least_size;
      });
      if (returns) {
        MachineGuess guess = guess_of(since, mark->time);
        guess.duration = t.time - mark->time;
        return moves && guess.events.size() >= 2 ? Settled{Kind::periodic, guess, t.X}
                                                 : without_events(simulation);
      }
      if (events >= first_mark && (events & (events - 1)) == 0) {
        mark = t;
        since.clear();
      }
      since.push_back(t);
    }
  }
  return {Kind::unsettled, {}, simulation.state()};
}

}  // namespace

Settled settle(const Machine& machine, const Eigen::VectorXd& X, long most_periods) {
  require_machine(machine, false);
  const auto size = static_cast<Eigen::Index>(2 * machine.oscillator.size());
  if (X.size() != size) {
    throw DomainError("the state", fmt::format("{} numbers", X.size()),
                      fmt::format("{}, positions and velocities", size));
  }
  const Simulation simulation(oscillator_as<double>(machine), 0, X);
  return machine.oscillator.is_autonomous() ? without_load(simulation, most_periods)
                                            : with_load(simulation, most_periods);
}

}  // namespace stickslip::numeric::machines
