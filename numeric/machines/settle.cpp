#include "numeric/machines/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "numeric/attractors/lyapunov.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr double nearness = 1e-9;
// A motion whose events are no farther apart than this has come to rest, or slides steadily.
constexpr double least_size = 1e-6;
// Two states of a motion that has returned nearer than this are one.
constexpr double same_state = 1e-6;
constexpr long first_mark = 8;
// Of a motion without a load, between two looks.
constexpr long steps_at_once = 1000;
// So many steps without an event: it slides or sticks for good.
constexpr long most_steps_without_event = 1000000;

using attractors::Kind;

double distance(const Eigen::VectorXd& X, const Eigen::VectorXd& Y) {
  return (X - Y).lpNorm<Eigen::Infinity>() /
         std::max({X.lpNorm<Eigen::Infinity>(), Y.lpNorm<Eigen::Infinity>(), 1e-300});
}

template <class Transition>
MachineGuess guess_of(const model::FrictionOscillator<double>& o, const std::vector<Transition>& log,
                      double begin) {
  return {events_of(o, log, begin)};
}

// Of a motion that is a shorter one taken several times, once. With a load that is one of fewer periods.
MachineGuess once(const MachineGuess& guess, bool has_load) {
  const std::size_t count = guess.events.size();
  for (std::size_t part = 2; part < count; ++part) {
    const std::size_t times = count / part;
    bool same = count % part == 0 && (!has_load || guess.periods % static_cast<long>(times) == 0);
    for (std::size_t i = 0; same && i < count; ++i) {
      const MachineGuess::Event &one = guess.events[i], &later = guess.events[(i + part) % count];
      same = one.begins == later.begins && distance(one.X, later.X) < same_state;
    }
    if (same) {
      MachineGuess shorter = guess;
      shorter.events.resize(part);
      shorter.duration /= static_cast<double>(times);
      shorter.periods = has_load ? guess.periods / static_cast<long>(times) : 1;
      return shorter;
    }
  }
  return guess;
}

// Begun at the first rotation of its word.
MachineGuess rotated(const MachineGuess& guess) {
  const std::size_t count = guess.events.size();
  const auto kind = [&](std::size_t i) { return guess.events[i % count].begins.kind; };
  std::string letters;
  std::vector<std::size_t> begins;  // of each letter
  for (std::size_t i = 0; i < count; ++i) {
    if (kind(i) != kind(i + count - 1)) {
      letters += words::letter(kind(i));
      begins.push_back(i);
    }
  }
  if (begins.empty()) {
    return guess;
  }
  const std::size_t from = begins[words::first_rotation(letters)];
  MachineGuess result = guess;
  for (std::size_t i = 0; i < from; ++i) {
    result.events[i].t += guess.duration;
  }
  std::rotate(result.events.begin(), result.events.begin() + static_cast<std::ptrdiff_t>(from),
              result.events.end());
  return result;
}

template <class Simulation>
Settled without_events(const Simulation& simulation) {
  const bool sticks = simulation.phase() == motion::PhaseKind::stick;
  return {sticks ? Kind::stuck : Kind::slides, {}, simulation.state()};
}

template <class Simulation>
Settled with_load(const model::FrictionOscillator<double>& o, Simulation simulation, long most_periods) {
  Eigen::VectorXd mark = simulation.state();
  long marked = 0;
  for (long k = 1; k <= most_periods && !interrupted(); ++k) {
    simulation.advance(simulation.period());
    const Eigen::VectorXd X = simulation.state();
    if (marked > 0 && distance(X, mark) < nearness) {
      const double begin = simulation.time();
      std::vector<typename Simulation::Transition> log;
      for (long i = 0; i < k - marked; ++i) {
        simulation.advance(simulation.period(), &log);
      }
      MachineGuess guess = guess_of(o, log, begin);
      guess.periods = k - marked;
      guess.duration = static_cast<double>(guess.periods) * simulation.period();
      return guess.events.size() < 2
                 ? without_events(simulation)
                 : Settled{Kind::periodic, rotated(once(guess, true)), simulation.state()};
    }
    if (k >= first_mark && (k & (k - 1)) == 0) {
      mark = X;
      marked = k;
    }
  }
  const bool tells = most_periods / 4 >= attractors::fewest_periods_of_exponent && !interrupted();
  return {tells ? attractors::kind_by(attractors::largest_exponent(simulation, most_periods / 4))
                : Kind::unsettled,
          {},
          simulation.state()};
}

template <class Simulation>
Settled without_load(const model::FrictionOscillator<double>& o, Simulation simulation, long most_events) {
  using Transition = typename Simulation::Transition;
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
        MachineGuess guess = guess_of(o, since, mark->time);
        guess.duration = t.time - mark->time;
        return moves && guess.events.size() >= 2 ? Settled{Kind::periodic, rotated(once(guess, false)), t.X}
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

namespace {

using AnySimulation = simulation::SimulationOf<Eigen::Dynamic, Eigen::Dynamic>;

void require_state(const Machine& machine, const Eigen::VectorXd& X) {
  require_machine(machine);
  const auto size = static_cast<Eigen::Index>(2 * machine.oscillator.size());
  if (X.size() != size) {
    throw DomainError("the state", fmt::format("{} numbers", X.size()),
                      fmt::format("{}, positions and velocities", size));
  }
}

}  // namespace

Settled settle(const Machine& machine, const Eigen::VectorXd& X, long most_periods) {
  require_state(machine, X);
  const model::FrictionOscillator<double> o = oscillator_as<double>(machine);
  if (machine.oscillator.is_autonomous()) {
    return without_load(o, AnySimulation(o, 0, X), most_periods);
  }
  const auto varying = [](const auto& load) { return load.k != 0; };
  const auto first = std::find_if(o.loads.begin(), o.loads.end(), varying);
  const bool one_frequency = std::all_of(
      o.loads.begin(), o.loads.end(), [&](const auto& load) { return !varying(load) || load.k == first->k; });
  if (o.size() == 2 && one_frequency) {
    return with_load(o, simulation::SimulationOf<2, 1>(o, 0, X), most_periods);
  }
  return with_load(o, AnySimulation(o, 0, X), most_periods);
}

MachineGuess over_periods(const Machine& machine, const Eigen::VectorXd& X, long n) {
  require_state(machine, X);
  if (machine.oscillator.is_autonomous()) {
    throw UsageError("periods of the load are counted where there is a load that varies");
  }
  const model::FrictionOscillator<double> o = oscillator_as<double>(machine);
  AnySimulation simulation(o, 0, X);
  std::vector<AnySimulation::Transition> log;
  for (long k = 0; k < n; ++k) {
    simulation.advance(simulation.period(), &log);
  }
  MachineGuess guess = guess_of(o, log, 0);
  guess.periods = n;
  guess.duration = static_cast<double>(n) * simulation.period();
  return rotated(guess);
}

}  // namespace stickslip::numeric::machines
