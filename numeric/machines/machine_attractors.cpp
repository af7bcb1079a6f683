#include "numeric/machines/machine_attractors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/attractors/attractors.hpp"
#include "numeric/machines/reaching.hpp"

namespace stickslip::numeric::machines {

using attractors::Kind;

namespace {

// Two simulated motions nearer than this, in parts of their size, are one.
constexpr double same_motion = 1e-6;

std::vector<Eigen::VectorXd> random_starts(const model::FrictionOscillator<double>& o, long count,
                                           std::uint64_t seed) {
  const MachineStartBox box = start_box(o);
  // Distributions of the standard library differ from one to another; the engine does not.
  std::mt19937_64 engine(seed);
  std::vector<Eigen::VectorXd> starts(static_cast<std::size_t>(count), box.middle);
  for (Eigen::VectorXd& X : starts) {
    for (Eigen::Index i = 0; i < X.size(); ++i) {
      const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
      X(i) += box.half(i) * (2 * share - 1);
    }
  }
  return starts;
}

// Whether the events of one are those of the other, begun with another one.
bool is_same(const MachineGuess& a, const MachineGuess& b) {
  const std::size_t count = a.events.size();
  if (count != b.events.size() || a.periods != b.periods) {
    return false;
  }
  const auto same_from = [&](std::size_t shift) {
    for (std::size_t i = 0; i < count; ++i) {
      const MachineGuess::Event &one = a.events[i], &other = b.events[(i + shift) % count];
      const double size = std::max(one.X.lpNorm<Eigen::Infinity>(), other.X.lpNorm<Eigen::Infinity>());
      if (one.begins != other.begins ||
          !((one.X - other.X).lpNorm<Eigen::Infinity>() <= same_motion * size)) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t shift = 0; shift < count; ++shift) {
    if (same_from(shift)) {
      return true;
    }
  }
  return false;
}

std::vector<Piece> pieces_of(const MachineGuess& guess) {
  std::vector<Piece> pieces;
  for (const MachineGuess::Event& event : guess.events) {
    pieces.push_back(event.begins);
  }
  return pieces;
}

}  // namespace

MachineAttractors find_attractors(const MachineStarts& question) {
  require_machine(question.machine);
  MachineAttractors result = find_attractors_from(
      question, random_starts(oscillator_as<double>(question.machine), question.starts, question.seed));
  if (question.machine.oscillator.is_autonomous()) {
    result.steady = steady_sliding(question.machine, question.digits);
  }
  return result;
}

MachineAttractors find_attractors_from(const MachineStarts& question,
                                       const std::vector<Eigen::VectorXd>& starts) {
  require_machine(question.machine);
  MachineAttractors result{question, {}, {}, false};
  result.question.starts = static_cast<long>(starts.size());
  const std::vector<Settled> ends = parallel_map(starts.size(), [&](std::size_t i) {
    return interrupted() ? Settled{Kind::unsettled, {}, starts[i]}
                         : settle(question.machine, starts[i], question.most_periods);
  });
  result.interrupted = interrupted();
  std::vector<const Settled *> first;  // of each attractor
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Settled& end = ends[i];
    std::size_t k = 0;
    while (k < first.size() && !(first[k]->kind == end.kind &&
                                 (end.kind != Kind::periodic || is_same(first[k]->guess, end.guess)))) {
      ++k;
    }
    if (k == first.size()) {
      first.push_back(&end);
      result.attractors.emplace_back();
      result.attractors.back().kind = end.kind;
      result.attractors.back().state = end.state;
    }
    result.attractors[k].members.push_back(i);
    ++result.attractors[k].count;
  }
  const auto orbits = parallel_map(first.size(), [&](std::size_t k) -> std::optional<MachineOrbit> {
    if (first[k]->kind != Kind::periodic || interrupted()) {
      return std::nullopt;
    }
    MachineOrbit orbit = prove_machine_orbit(question.machine, first[k]->guess, question.digits);
    if (orbit.existence.truth == Truth::proved &&
        !(distance(guess_of(orbit, question.machine), first[k]->guess) < most_astray)) {
      orbit = {};
      orbit.existence = Verdict::undecided("Newton's method leads from there to another motion");
    }
    return orbit;
  });
  for (std::size_t k = 0; k < first.size(); ++k) {
    MachineAttractor& a = result.attractors[k];
    const attractors::Interval interval = attractors::wilson(a.count, result.question.starts);
    a.share = static_cast<double>(a.count) / static_cast<double>(result.question.starts);
    a.least = interval.least;
    a.most = interval.most;
    a.orbit = orbits[k];
    a.word = a.kind == Kind::periodic ? word_of(pieces_of(first[k]->guess)) : "";
  }
  std::stable_sort(result.attractors.begin(), result.attractors.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
  return result;
}

namespace {

std::vector<Eigen::VectorXd> states_of(const Machine& machine, const MachineAttractor& a) {
  if (machine.oscillator.is_autonomous()) {
    if (!a.orbit || a.orbit->existence.truth != Truth::proved) {
      return {a.state};
    }
    std::vector<Eigen::VectorXd> states;
    motion::PhaseKind before = a.orbit->phases.back().piece.kind;
    for (const MachinePhase& phase : a.orbit->phases) {
      if (phase.piece.kind != before) {
        states.emplace_back(phase.state.unaryExpr([](const Ball& x) { return x.approximate(); }));
      }
      before = phase.piece.kind;
    }
    return states;
  }
  const bool moves = a.kind != Kind::stuck && a.kind != Kind::unsettled;
  const long count = a.kind == Kind::periodic && a.orbit ? std::min(a.orbit->periods, most_once)
                     : moves                             ? most_once
                                                         : 1;
  return attractors::states_once_a_period<Eigen::VectorXd>(
      simulation::SimulationOf<Eigen::Dynamic, Eigen::Dynamic>(oscillator_as<double>(machine), 0, a.state),
      count);
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
  MachineStartBox box = start_box(oscillator_as<double>(machine));
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
    if (guess.events.size() < 2 || !is_of(q, word_of(pieces_of(guess)), guess.periods)) {
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
                  name_of(end.kind, word_of(pieces_of(end.guess)), end.guess.periods, autonomous);
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
  const MachineAttractors list =
      find_attractors({.machine = question.machine, .starts = starts, .digits = question.digits});
  MachineWordOrbits result{question, {}, {}, list.interrupted};
  std::vector<std::string> others;
  for (const MachineAttractor& a : list.attractors) {
    const long periods = a.orbit ? a.orbit->periods : 0;
    if (a.orbit && a.orbit->existence.truth == Truth::proved && is_of(question, a.word, periods)) {
      result.orbits.push_back(*a.orbit);
    } else {
      others.push_back(name_of(a.kind, a.word, periods, question.machine.oscillator.is_autonomous()));
    }
  }
  if (result.orbits.empty()) {
    result.seen = fmt::format("{} random starts end on: {}", starts, fmt::join(others, ", "));
  }
  return result;
}

}  // namespace stickslip::numeric::machines
