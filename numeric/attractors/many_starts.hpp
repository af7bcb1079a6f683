// What many starts end on, for any oscillator.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/rational.hpp"

namespace stickslip::numeric::attractors {

// The kinds of motion that a simulation settles on, and how many of many starts end on one.

enum class Kind {
  periodic,        // after n periods of the load, with events in each n of them
  quasi_periodic,  // does not return, and neighbours do not leave it exponentially
  irregular,       // neighbours leave it exponentially
  slides,          // never touches the belt's speed again
  stuck,           // stays on a belt that does not move
  grows,           // beyond all bounds, proved
  unsettled,       // within the periods that were allowed
};

// "periodic", "quasi-periodic", "irregular", "slides", "stuck", "grows without bound",
// "unsettled".
[[nodiscard]] std::string to_string(Kind kind);

// What starts end on, whatever is proved of it.
struct Ending {
  Kind kind = Kind::unsettled;
  std::vector<std::size_t> members;       // which starts end on it
  long count = 0;                         // how many
  double share = 0, least = 0, most = 0;  // with Wilson's interval of 95 %
  std::string word;                       // periodic: its letters, in the first rotation
  long periods = 0;                       // periodic: n
  bool is_too_slow = false;        // unsettled: a period of the load takes too many steps to be followed
  std::optional<double> lyapunov;  // irregular, quasi-periodic: a check, the mean over its starts
};

// What many starts end on.
template <class Attractor>
struct Endings {
  // By falling count. Irregular motions are one entry, and so are those of each other kind that is not
  // periodic: a simulation cannot tell how many attractors they are.
  std::vector<Attractor> attractors;
  long simulated = 0;  // periods in all
  bool interrupted = false;
  long followed = 0;  // starts, until they had settled or for all periods; the shares are of these
};

// Wilson's interval of 95 % for a share of which `count` of `total` are a sample.
struct Interval {
  double least, most;
};
[[nodiscard]] Interval wilson(long count, long total);

// What many starts end on, for any oscillator: while one datum varies, and over a plane that they lie in.

// At one value of the datum.
template <class Attractor, class State>
struct PointAlong {
  Rational value;
  std::string outside;  // of the domain, in one sentence; nothing else is known then
  std::vector<Attractor> attractors;
  std::vector<std::vector<State>> once;  // of each of them, states to be drawn
};

// How many states of what was settled on are drawn, one period of the load apart: n of a periodic motion, but
// at most `most`; so many of one that moves and is not periodic; else one.
inline constexpr long most_once = 200;
[[nodiscard]] inline long count_once(const Ending& a, long most = most_once) {
  const bool rests = a.kind == Kind::stuck || a.kind == Kind::grows || a.kind == Kind::unsettled;
  return a.kind == Kind::periodic ? std::min(a.periods, most) : rests ? 1 : most;
}

// The state and those that follow it one period of the load apart, so many in all; fewer after an
// interruption.
template <class State, class Simulation>
[[nodiscard]] std::vector<State> states_once_a_period(Simulation simulation, long count) {
  std::vector<State> states{simulation.state()};
  while (static_cast<long>(states.size()) < count && !interrupted()) {
    simulation.advance(simulation.period());
    states.emplace_back(simulation.state());
  }
  return states;
}

// The points at so many values from `from` to `to`, both among them; `look` fills in one that has its value,
// and says whether it was not interrupted: else there are no more. Throws DomainError when no value is in the
// domain.
template <class Point, class Look>
[[nodiscard]] std::vector<Point> points_along(const Rational& from, const Rational& to, long values,
                                              const Look& look) {
  std::vector<Point> points;
  std::optional<DomainError> outside;
  bool any = false;
  for (long k = 0; k < values; ++k) {
    Point point;
    Rational share(k, values - 1);
    share.canonicalize();
    point.value = from + (to - from) * share;
    try {
      if (!look(point)) {
        return points;
      }
      any = true;
    } catch (const DomainError& error) {
      outside = error;
      point.outside = error.what();
    }
    points.push_back(std::move(point));
  }
  if (!any && outside) {
    throw DomainError(*outside);
  }
  return points;
}

// Where starts lie: within `half` of `middle` in each coordinate.
template <class State>
struct StartBoxOf {
  State middle, half;
};

// At random in the box, each coordinate uniformly. The same seed gives the same states everywhere; the first
// ones do not depend on how many there are.
template <class State>
[[nodiscard]] std::vector<State> random_starts_in(const StartBoxOf<State>& box, std::size_t count,
                                                  std::uint64_t seed) {
  // Distributions of the standard library differ from one to another; the engine does not.
  std::mt19937_64 engine(seed);
  std::vector<State> starts(count, box.middle);
  for (State& X : starts) {
    for (Eigen::Index i = 0; i < X.size(); ++i) {
      const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
      X(i) += box.half(i) * (2 * share - 1);
    }
  }
  return starts;
}

// The middles of columns and rows of pixels of a window that is `half` to each side of the middle, row by
// row; the first coordinate rises first.
template <class State>
[[nodiscard]] std::vector<State> starts_in_plane(const State& middle, const State& half,
                                                 const std::array<int, 2>& across,
                                                 const std::array<long, 2>& pixels) {
  std::vector<State> starts;
  const auto at = [&](int axis, long pixel, long count) {
    return middle(axis) +
           half(axis) * (2 * (static_cast<double>(pixel) + 0.5) / static_cast<double>(count) - 1);
  };
  for (long row = 0; row < pixels[1]; ++row) {
    for (long column = 0; column < pixels[0]; ++column) {
      State X = middle;
      X(across[0]) = at(across[0], column, pixels[0]);
      X(across[1]) = at(across[1], row, pixels[1]);
      starts.push_back(X);
    }
  }
  return starts;
}

// On which of the attractors each start ends.
template <class Attractor>
[[nodiscard]] std::vector<std::size_t> ends_of(const std::vector<Attractor>& attractors, std::size_t starts) {
  std::vector<std::size_t> at(starts);
  for (std::size_t a = 0; a < attractors.size(); ++a) {
    for (const std::size_t start : attractors[a].members) {
      at[start] = a;
    }
  }
  return at;
}

}  // namespace stickslip::numeric::attractors
