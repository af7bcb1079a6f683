#include "numeric/attractors/settle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/interruption.hpp"
#include "numeric/attractors/lyapunov.hpp"

namespace stickslip::numeric::attractors {

using model::Vector4;
using motion::PhaseKind;
using simulation::Simulation;
using simulation::Transition;

namespace {

// Rounding is far below it, and what is slower than this is seen by the lack of events.
constexpr double certainly = 1 - 1e-9;
// Fewer periods without an event say nothing.
constexpr long long_time = 256;
// What rounding leaves of a return after hundreds of periods with transients that stretch it.
constexpr double within_rounding = 2e-8;

// A period of the load is gone through in so many pieces of so many steps at most: a slower load is not
// followed.
constexpr int most_pieces = 20;
constexpr long steps_in_piece = 100000;

// The mass touches the belt's speed and leaves it again to the same side: no event of a word.
bool is_event(const Transition& t) {
  return t.before != t.after;
}

// Whether the motion that has come back after n periods comes back after n more, and nearer: a quasi-periodic
// one comes as near as before, an irregular one less near. A return within rounding is as near as it gets.
bool returns_again(Simulation simulation, long n, double before) {
  const Vector4<double> X = simulation.state();
  for (long k = 0; k < n; ++k) {
    simulation.advance(simulation.period());
  }
  const double again = distance(simulation.state(), X);
  return again < 0.9 * before || again < within_rounding;
}

}  // namespace

double distance(const Vector4<double>& X, const Vector4<double>& Y) {
  return (X - Y).lpNorm<Eigen::Infinity>() /
         std::max(X.lpNorm<Eigen::Infinity>(), Y.lpNorm<Eigen::Infinity>());
}

Vector4<double> at_phase_0(const simulation::Start& start) {
  const double turn = 2 * std::numbers::pi;
  const double phase = std::fmod(start.phi, turn);
  Simulation simulation(start.data, start.ur, phase, start.X);
  simulation.advance((phase > 0 ? turn - phase : -phase) / start.data.omega);
  return simulation.state();
}

std::optional<Return> steady_word(const Simulation& simulation) {
  constexpr long most = 8;
  for (long n = 1; n <= most; ++n) {
    const Return once = over_periods(simulation, n);
    if (words::is_word(once.word) && over_periods(simulation, 2 * n).word == once.word + once.word) {
      return once;
    }
  }
  return std::nullopt;
}

bool nears(Simulation simulation, const Vector4<double>& X, double mu, long n, long periods) {
  constexpr double least = 1e-3;
  constexpr long parts = 9;  // of which the first, the middle and the last are compared
  const long returns = periods / (parts * n);
  std::array<double, parts> farthest{};
  for (double& most : farthest) {
    for (long k = 0; k < returns; ++k) {
      for (long i = 0; i < n; ++i) {
        simulation.advance(simulation.period());
      }
      most = std::max(most, distance(simulation.state(), X));
    }
  }
  const double expected = -std::log(mu) * static_cast<double>(parts / 2 * returns);
  const auto falls = [&](double before, double after) {
    const double by = std::log(before / after);
    return by > least && by > expected / 2 && by < expected * 2;
  };
  return falls(farthest.front(), farthest[parts / 2]) && falls(farthest[parts / 2], farthest.back());
}

Follower::Follower(const model::Parameters<double>& a, double ur, const Vector4<double>& X)
    : simulation_(a, ur, 0, X), oscillator_(model::oscillator<double>(a)) {}

bool Follower::slides_for_good() const {
  const PhaseKind kind = simulation_.phase();
  const double V = simulation_.data().V;
  const bool slip = kind == PhaseKind::slip;
  if (kind == PhaseKind::stick || (slip ? V <= 0 : V >= 0)) {
    return false;
  }
  Vector4<double> Z = simulation_.state();
  Z.head<2>() -= oscillator_.d0;
  const model::Wave<double> speed = model::slip_waves<double>(oscillator_, slip ? 1 : -1, 0.0, Z).zdot2;
  double sum = 0;
  for (int k = 0; k < speed.count; ++k) {
    const auto& h = speed.harmonics[static_cast<std::size_t>(k)];
    sum += std::hypot(h.a, h.b);
  }
  return sum < certainly * std::abs(V);
}

// On a stick x1 - chi x2 oscillates with a fixed amplitude, so r of (4) is at most what is compared.
bool Follower::sticks_for_good() const {
  const model::Parameters<double>& a = simulation_.data();
  if (simulation_.phase() != PhaseKind::stick || a.V != 0) {
    return false;
  }
  const Vector4<double> X = simulation_.state();
  const double amplitude = std::hypot(X(0) - a.chi * X(1), X(2));
  const double most = a.chi * (1 - a.chi) * std::abs(X(1)) + a.chi * amplitude + a.p / a.eta;
  return most < certainly * simulation_.ur();
}

bool Follower::goes_through_period(std::vector<Transition>& log) {
  double left = simulation_.period();
  for (int piece = 0; piece < most_pieces; ++piece) {
    const std::size_t before = log.size();
    left = simulation_.advance(left, &log, steps_in_piece);
    if (left <= 0) {
      return true;
    }
    if (interrupted()) {
      return false;
    }
    if (log.size() == before && sticks_for_good()) {
      kind_ = Kind::stuck;
      return false;
    }
  }
  is_too_slow_ = true;
  return false;
}

void Follower::follow(long most_periods, double nearness) {
  kind_ = Kind::unsettled;
  Vector4<double> mark = simulation_.state();
  long marked = periods_;
  long next_mark = std::max(2 * periods_, 8L);
  bool looks = periods_ == 0;
  std::vector<Transition> log;
  while (periods_ < most_periods && !is_too_slow_) {
    log.clear();
    if (!goes_through_period(log)) {
      return;
    }
    ++periods_;
    if (std::any_of(log.begin(), log.end(), is_event)) {
      last_event_ = periods_;
    } else if (slides_for_good() || sticks_for_good()) {
      kind_ = simulation_.phase() == PhaseKind::stick ? Kind::stuck : Kind::slides;
      return;
    }
    const Vector4<double> X = simulation_.state();
    // A motion without an event since the mark has its word to come, or none.
    if (looks && last_event_ > marked && distance(X, mark) < nearness &&
        returns_again(simulation_, periods_ - marked, distance(X, mark))) {
      kind_ = Kind::periodic;
      period_ = periods_ - marked;
      return;
    }
    if (periods_ >= next_mark) {
      if (interrupted()) {
        return;
      }
      mark = X;
      marked = periods_;
      looks = true;
      next_mark *= 2;
    }
  }
  if (periods_ - last_event_ > std::max(long_time, periods_ / 2)) {
    kind_ = simulation_.phase() == PhaseKind::stick ? Kind::stuck : Kind::slides;
  }
}

Return over_periods(Simulation simulation, long n) {
  const double begin = simulation.time();
  Return result;
  result.guess.periods = n;
  std::vector<Transition> log;
  for (long k = 0; k < n; ++k) {
    result.once.push_back(simulation.state());
    simulation.advance(simulation.period(), &log);
  }
  for (const Transition& t : log) {
    if (is_event(t)) {
      result.guess.events.push_back({t.time - begin, t.X(0), t.X(1), t.X(2), t.after});
      result.word += words::letter(t.after);
    }
  }
  std::rotate(result.word.begin(),
              result.word.begin() + static_cast<std::ptrdiff_t>(words::first_rotation(result.word)),
              result.word.end());
  return result;
}

std::optional<Return> Follower::returned() const {
  if (kind_ != Kind::periodic) {
    return std::nullopt;
  }
  const Return result = over_periods(simulation_, period_);
  return words::is_word(result.word) ? std::optional(result) : std::nullopt;
}

void Follower::classify(long periods) {
  if (kind_ != Kind::unsettled || periods < fewest_periods_of_exponent || is_too_slow_) {
    return;
  }
  const Exponent exponent = largest_exponent<2, 1>(simulation_, periods);
  lyapunov_ = exponent.value;
  kind_ = kind_by(exponent);
}

}  // namespace stickslip::numeric::attractors
