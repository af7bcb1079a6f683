#include "numeric/machines/attractors/machine_attractors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/interruption.hpp"
#include "numeric/attractors/survey.hpp"
#include "numeric/machines/basins/neighbourhood.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using attractors::Kind;
using attractors::Return;
using simulation::AnySimulation;

namespace {

// As survey.hpp asks for it.
struct MachineProofs {
  using Attractor = MachineAttractor;

  Machine machine;
  int digits;
  double scale = scale_of(oscillator_as<double>(machine));

  [[nodiscard]] double Omega() const { return scale; }
  [[nodiscard]] static bool provable() { return true; }
  [[nodiscard]] Return tidied(const Return& seen) const { return machines::tidied(machine, seen); }
  [[nodiscard]] std::optional<MachineOrbit> prove(const Return& seen) const {
    return prove_machine_orbit(machine, seen.guess, digits,
                               std::max(attractors::most_bits_of_stable, 2 * scalars::bits_for(digits)));
  }
  [[nodiscard]] static const MachineOrbit& judged(const MachineOrbit& orbit) { return orbit; }
  [[nodiscard]] static std::string word(const MachineOrbit& orbit) { return word_of(orbit.pieces); }
  [[nodiscard]] static Eigen::VectorXd begins_at(const MachineOrbit& orbit) {
    return zeros::in_double(orbit.phases.front().state);
  }
  [[nodiscard]] Eigen::VectorXd at_phase_0(const MachineOrbit& orbit) const {
    const double theta = std::fmod(orbit.load.approximate(), 2 * std::numbers::pi);
    const auto o = oscillator_as<double>(machine);
    AnySimulation simulation(o, theta, begins_at(orbit));
    simulation.advance((theta > 0 ? 2 * std::numbers::pi - theta : -theta) / o.omega);
    return simulation.state();
  }
  // Begun with the same phase, or with another one: a state tells the motion.
  [[nodiscard]] static bool overlap(const MachineOrbit& a, const MachineOrbit& b) {
    const MachinePhase& first = a.phases.front();
    return a.phases.size() == b.phases.size() && a.periods == b.periods &&
           std::ranges::any_of(b.phases, [&](const MachinePhase& phase) {
             return phase.piece == first.piece && phase.duration.overlaps(first.duration) &&
                    std::ranges::equal(phase.state, first.state,
                                       [](const Ball& x, const Ball& y) { return x.overlaps(y); });
           });
  }
  [[nodiscard]] static const Attractor& completed(const Attractor& a) { return a; }
  // Of a return no proof was tried.
  [[nodiscard]] static Kind kind(Kind seen) { return seen == Kind::periodic ? Kind::unsettled : seen; }
};

}  // namespace

MachineAttractors find_attractors(const MachineStarts& question) {
  require_machine(question.machine);
  MachineAttractors result = find_attractors_from(
      question, attractors::random_starts_in(start_box(oscillator_as<double>(question.machine)),
                                             static_cast<std::size_t>(question.starts), question.seed));
  if (question.machine.oscillator.is_autonomous()) {
    result.steady = steady_sliding(question.machine, question.digits);
  }
  return result;
}

MachineAttractors find_attractors_from(const MachineStarts& question,
                                       const std::vector<Eigen::VectorXd>& starts) {
  require_machine(question.machine);
  attractors::Survey<MachineProofs> survey({question.machine, question.digits}, question.most_periods,
                                           followers_of(question.machine, starts));
  MachineAttractors result{survey.endings(), question, {}};
  result.question.starts = static_cast<long>(starts.size());
  return result;
}

namespace {

std::vector<Eigen::VectorXd> states_of(const Machine& machine, const MachineAttractor& a) {
  if (machine.oscillator.is_autonomous()) {
    if (!a.orbit || a.orbit->existence.truth != Truth::proved) {
      return {a.state};
    }
    std::vector<Eigen::VectorXd> states;
    for (const std::size_t i : begins_of_phases(a.orbit->pieces)) {
      states.push_back(zeros::in_double(a.orbit->phases[i].state));
    }
    return states;
  }
  return attractors::states_once_a_period<Eigen::VectorXd>(
      AnySimulation(oscillator_as<double>(machine), 0, a.state), attractors::count_once(a));
}

}  // namespace

MachineDiagram along(MachineDiagram diagram) {
  using Point = attractors::PointAlong<MachineAttractor, Eigen::VectorXd>;
  diagram.points =
      attractors::points_along<Point>(diagram.from, diagram.to, diagram.values, [&](Point& point) {
        MachineStarts here = diagram.question;
        here.machine = diagram.at(point.value);
        const MachineAttractors list = find_attractors(here);
        point.attractors = list.attractors;
        for (const MachineAttractor& a : list.attractors) {
          point.once.push_back(states_of(here.machine, a));
        }
        diagram.interrupted = list.interrupted;
        return !list.interrupted;
      });
  return diagram;
}

double proved_share(const MachineBasins& basins) {
  const auto count = std::ranges::count(basins.proved, char{1});
  return basins.proved.empty() ? 0 : static_cast<double>(count) / static_cast<double>(basins.proved.size());
}

MachineBasins in_plane(MachineBasins basins) {
  const Machine& machine = basins.question.machine;
  require_machine(machine);
  auto box = start_box(oscillator_as<double>(machine));
  for (std::size_t axis = 0; basins.half && axis < 2; ++axis) {
    box.half(basins.across[axis]) = (*basins.half)[axis];
  }
  basins.starts = attractors::starts_in_plane<Eigen::VectorXd>(basins.through.value_or(box.middle), box.half,
                                                               basins.across, basins.pixels);
  const MachineAttractors list = find_attractors_from(basins.question, basins.starts);
  basins.attractors = list.attractors;
  basins.interrupted = list.interrupted;
  basins.ends = attractors::ends_of(list.attractors, basins.starts.size());
  if (!basins.prove) {
    return basins;
  }
  std::vector<std::shared_ptr<const Neighbourhood>> all;
  for (MachineAttractor& a : basins.attractors) {
    if (a.orbit) {
      a.orbit->neighbourhood = std::make_shared<Neighbourhood>(neighbourhood_of(machine, *a.orbit));
    }
    all.push_back(a.orbit ? a.orbit->neighbourhood : nullptr);
  }
  Pixels pixels{basins.starts, basins.across, {}, basins.pixels};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    pixels.half[axis] = box.half(basins.across[axis]) / static_cast<double>(basins.pixels[axis]);
  }
  const auto ends = reached(machine, pixels, all);
  basins.proved.clear();
  for (std::size_t i = 0; i < basins.starts.size(); ++i) {
    basins.proved.push_back(ends[i] ? 1 : 0);
    basins.ends[i] = ends[i].value_or(basins.ends[i]);
  }
  basins.interrupted = basins.interrupted || interrupted();
  return basins;
}

namespace {

std::string name_of(Kind kind, const std::string& word, long periods, bool autonomous) {
  return kind != Kind::periodic ? to_string(kind)
         : autonomous           ? word
                                : fmt::format("{} with the period {}", word, periods);
}

bool is_of(const MachineWord& q, const std::string& word, long periods) {
  return word == q.word.letters() && (!q.periods || *q.periods == periods);
}

MachineWordOrbits from_start(const MachineWord& q) {
  MachineWordOrbits result{q, {}, {}};
  const bool autonomous = q.machine.oscillator.is_autonomous();
  const auto attempt = [&](const MachineGuess& guess) {
    if (guess.events.size() < 2 || !is_of(q, word_of(guess.pieces()), guess.periods)) {
      return false;
    }
    const MachineOrbit orbit = prove_machine_orbit(q.machine, guess, q.digits);
    if (orbit.existence.truth == Truth::proved) {
      result.orbits.push_back(orbit);
    }
    return !result.orbits.empty();
  };
  if (!autonomous && attempt(over_periods(q.machine, *q.near, q.periods.value_or(1)))) {
    return result;
  }
  const Settled end = settle(q.machine, *q.near);
  if (!attempt(end.guess)) {
    result.seen = "the motion from there: " +
                  name_of(end.kind, word_of(end.guess.pieces()), end.guess.periods, autonomous);
  }
  result.interrupted = interrupted();
  return result;
}

}  // namespace

MachineWordOrbits find_word_orbits(const MachineWord& question) {
  require_machine(question.machine);
  if (question.near) {
    return from_start(question);
  }
  constexpr long starts = 100;
  MachineWordOrbits result{question, {}, {}};
  std::vector<std::string> others;
  for (const long most_periods : {2000L, MachineStarts().most_periods}) {
    const MachineAttractors list = find_attractors({.machine = question.machine,
                                                    .starts = starts,
                                                    .most_periods = most_periods,
                                                    .digits = question.digits});
    others.clear();
    for (const MachineAttractor& a : list.attractors) {
      const long periods = a.orbit ? a.orbit->periods : 0;
      if (a.orbit && a.orbit->existence.truth == Truth::proved && is_of(question, a.word, periods)) {
        result.orbits.push_back(*a.orbit);
      } else {
        others.push_back(name_of(a.kind, a.word, periods, question.machine.oscillator.is_autonomous()));
      }
    }
    result.interrupted = list.interrupted;
    if (!result.orbits.empty() || result.interrupted) {
      break;
    }
  }
  if (result.orbits.empty()) {
    result.seen = fmt::format("{} random starts end on: {}", starts, fmt::join(others, ", "));
  }
  return result;
}

}  // namespace stickslip::numeric::machines
