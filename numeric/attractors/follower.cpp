#include "numeric/attractors/follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/interruption.hpp"
#include "core/names.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::attractors {

using machines::MachineGuess;

namespace {

// Fewer periods without an event say nothing.
constexpr long long_time = 256;
// What rounding leaves of a return after hundreds of periods with transients that stretch it.
constexpr double within_rounding = 2e-8;
// A motion that comes back as near as this without an event on the way is at rest, or slides steadily,
constexpr double steadily = 1e-9;
// and so is one without a load whose events are no farther apart than this.
constexpr double least_size = 1e-6;
// The first period whose state is compared with later ones, but for the start.
constexpr long first_mark = 8;
// Of a Lyapunov exponent: fewer periods say nothing.
constexpr long fewest_periods_of_exponent = 100;

// A period of the load is gone through in so many pieces of so many steps at most: a slower load is not
// followed.
constexpr int most_pieces = 20;
constexpr long steps_in_piece = 100000;

// Of a motion without a load, between two looks, and without an event: then it slides or sticks for good.
constexpr long steps_at_once = 1000;
constexpr long most_steps_without_event = 1000000;

// The events of what was logged after `begin`, and the word. That the mass touches the belt's speed and
// leaves it again to the same side is no event.
template <class Transition>
Return seen_in(const model::FrictionOscillator<double>& o, const std::vector<Transition>& log, double begin) {
  Return result{{machines::events_of(o, log, begin)}, "", {}};
  for (const Transition& t : log) {
    if (t.before != t.after) {
      result.word += words::letter(t.after);
    }
  }
  result.word = words::in_first_rotation(result.word);
  return result;
}

// Whether the events can be those of a closed motion: there are two at least, and no piece follows itself.
bool may_close(const MachineGuess& guess) {
  const std::size_t count = guess.events.size();
  bool differ = count >= 2;
  for (std::size_t i = 0; i < count; ++i) {
    differ = differ && !(guess.events[i].begins == guess.events[(i + 1) % count].begins);
  }
  return differ;
}

}  // namespace

Return shortest(const Return& seen, bool has_load, double nearness, double Omega) {
  const std::vector<MachineGuess::Event>& events = seen.guess.events;
  const std::size_t count = events.size();
  for (std::size_t part = 2; part < count; ++part) {
    const std::size_t times = count / part;
    bool same = count % part == 0 && (!has_load || seen.guess.periods % static_cast<long>(times) == 0);
    for (std::size_t i = 0; same && i < count; ++i) {
      const MachineGuess::Event &one = events[i], &later = events[(i + part) % count];
      same = one.begins == later.begins && distance(one.X, later.X, Omega) < nearness;
    }
    if (same) {
      Return once = seen;
      once.guess = seen.guess.once_of(static_cast<long>(times), has_load);
      once.word.resize(seen.word.size() / times);
      once.once.resize(seen.once.size() / times);
      return once;
    }
  }
  return seen;
}

std::optional<Return> AnyFollower::steady_word() const {
  constexpr long most = 8;
  for (long n = 1; n <= most && has_load_; ++n) {
    const Return once = over_periods(n);
    if (words::is_word(once.word) && over_periods(2 * n).word == once.word + once.word) {
      return once;
    }
  }
  return std::nullopt;
}

template <int N, int L>
Return FollowerOf<N, L>::over_periods(long n) const {
  Simulation simulation = simulation_;
  std::vector<Eigen::VectorXd> once;
  std::vector<Transition> log;
  for (long k = 0; k < n; ++k) {
    once.emplace_back(simulation.state());
    simulation.advance(simulation.period(), &log);
  }
  Return result = seen_in(o_, log, simulation_.time());
  result.guess.periods = n;
  result.guess.duration = static_cast<double>(n) * simulation.period();
  result.once = std::move(once);
  return result;
}

// A periodic motion comes back after n more, and nearer: a quasi-periodic one comes as near as before, an
// irregular one less near. A return within rounding is as near as it gets.
template <int N, int L>
bool FollowerOf<N, L>::returns(long n, double before) {
  Simulation simulation = simulation_;
  for (long k = 0; k < n; ++k) {
    simulation.advance(simulation.period());
  }
  const double again = distance(simulation.state(), simulation_.state(), Omega_);
  if (!(again < 0.9 * before || again < within_rounding)) {
    return false;
  }
  return_ = over_periods(n);
  return may_close(return_.guess);
}

template <int N, int L>
bool FollowerOf<N, L>::goes_through_period(std::vector<Transition>& log) {
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
    if (log.size() == before && for_good_ && for_good_(simulation_) == Kind::stuck) {
      kind_ = Kind::stuck;
      return false;
    }
  }
  is_too_slow_ = true;
  return false;
}

template <int N, int L>
void FollowerOf<N, L>::follow(long most_periods, double nearness) {
  kind_ = Kind::unsettled;
  has_load_ ? follow_periods(most_periods, nearness) : follow_events(most_periods, nearness);
}

template <int N, int L>
void FollowerOf<N, L>::follow_periods(long most_periods, double nearness) {
  State mark = simulation_.state();
  long marked = periods_;
  long next_mark = std::max(2 * periods_, first_mark);
  bool looks = periods_ == 0;
  std::vector<Transition> log;
  while (periods_ < most_periods && !is_too_slow_) {
    log.clear();
    if (!goes_through_period(log)) {
      return;
    }
    ++periods_;
    if (std::ranges::any_of(log, [&](const Transition& t) { return machines::is_event(o_, t); })) {
      last_event_ = periods_;
    } else if (const auto known = for_good_ ? for_good_(simulation_) : std::nullopt) {
      kind_ = *known;
      return;
    }
    const State X = simulation_.state();
    const double back = looks ? distance(X, mark, Omega_) : 1;
    // A motion without an event since the mark has its word to come, or none.
    if (last_event_ > marked && back < nearness && returns(periods_ - marked, back)) {
      kind_ = Kind::periodic;
      return;
    }
    if (last_event_ <= marked && back < steadily) {
      kind_ = without_events();
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
    kind_ = without_events();
  }
}

template <int N, int L>
void FollowerOf<N, L>::follow_events(long most_events, double nearness) {
  std::optional<Transition> mark;
  std::vector<Transition> since, log;
  long next_mark = std::max(2 * periods_, first_mark);
  long idle = 0;
  while (periods_ < most_events && !interrupted()) {
    log.clear();
    simulation_.advance(1e300, &log, steps_at_once);
    idle = log.empty() ? idle + steps_at_once : 0;
    if (idle >= most_steps_without_event) {
      kind_ = without_events();
      return;
    }
    // On a smooth law ends of pieces count here, too, so that it is seen when nothing else happens.
    for (const Transition& t : log) {
      if (!t.changes()) {
        continue;
      }
      ++periods_;
      const double back =
          mark && t.after == mark->after && t.piece_after == mark->piece_after && t.before == mark->before
              ? distance(t.X, mark->X, Omega_)
              : 1;
      if (back < std::max(nearness, steadily)) {
        return_ = seen_in(o_, since, mark->time);
        return_.guess.duration = t.time - mark->time;
        for (const MachineGuess::Event& event : return_.guess.events) {
          return_.once.push_back(event.X);
        }
        const bool moves = std::ranges::any_of(
            since, [&](const Transition& other) { return distance(other.X, mark->X, Omega_) > least_size; });
        const bool closes = moves && may_close(return_.guess);
        if (closes ? back < nearness : back < steadily) {
          kind_ = closes ? Kind::periodic : without_events();
          return;
        }
      }
      if (periods_ >= next_mark) {
        mark = t;
        since.clear();
        next_mark *= 2;
      }
      since.push_back(t);
    }
  }
}

template <int N, int L>
void FollowerOf<N, L>::classify(long periods) {
  if (kind_ != Kind::unsettled || periods < fewest_periods_of_exponent || is_too_slow_ || !has_load_) {
    return;
  }
  const Exponent exponent = this->exponent(periods);
  lyapunov_ = exponent.value;
  kind_ = exponent.is_positive() ? Kind::irregular
          : exponent.is_zero()   ? Kind::quasi_periodic
                                 : Kind::unsettled;
}

template <int N, int L>
Exponent FollowerOf<N, L>::exponent(long periods) const {
  constexpr int blocks = 20;
  constexpr double small = 1e-8;
  Simulation simulation = simulation_;
  const long in_block = std::max(1L, periods / blocks);
  const long lead = blocks * in_block / 5;  // in which the neighbour turns into the fastest direction
  State X = simulation.state();
  const double size = small * std::max(X.norm(), 1e-100);
  // In all components, with one sign turned.
  const auto aside = [&](Eigen::Index turned) {
    State direction = State::Constant(X.size(), size / std::sqrt(static_cast<double>(X.size())));
    direction(std::min(turned, X.size() - 1)) *= -1;
    return direction;
  };
  State deviation = aside(1);
  Simulation neighbour = simulation;
  // How much the deviation grows in a period, as a logarithm; it is `size` long again after that. A neighbour
  // that falls together with the motion starts anew.
  const auto growth = [&] {
    neighbour.restart(0, X + deviation);
    simulation.advance(simulation.period());
    neighbour.advance(simulation.period());
    X = simulation.state();
    deviation = neighbour.state() - X;
    const double length = deviation.norm();
    if (!(length > 1e-6 * size)) {
      deviation = aside(2);
      return std::log(1e-6);
    }
    deviation *= size / length;
    return std::log(length / size);
  };
  for (long k = 0; k < lead && !interrupted(); ++k) {
    (void)growth();
  }
  double sum = 0;
  double squares = 0;
  for (int b = 0; b < blocks; ++b) {
    double mean = 0;
    for (long k = 0; k < in_block; ++k) {
      if (interrupted()) {
        return {};
      }
      mean += growth() / static_cast<double>(in_block);
    }
    sum += mean;
    squares += mean * mean;
  }
  const double value = sum / blocks;
  // From a fifth of the time to six fifths of it a deviation in proportion to time grows by six.
  const double least = 3 * std::log(6) / static_cast<double>(blocks * in_block);
  return {value, std::sqrt(std::max(0.0, squares / blocks - value * value) / (blocks - 1)), least};
}

template <int N, int L>
bool FollowerOf<N, L>::nears(const Eigen::VectorXd& X, double mu, long n, long periods) const {
  constexpr double least = 1e-3;
  constexpr long parts = 9, half = parts / 2;  // of which the first, the middle and the last are compared
  Simulation simulation = simulation_;
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
  const double expected = -std::log(mu) * static_cast<double>(half * returns);
  const auto falls = [&](double before, double after) {
    const double by = std::log(before / after);
    return by > least && by > expected / 2 && by < expected * 2;
  };
  return falls(farthest.front(), farthest[half]) && falls(farthest[half], farthest.back());
}

template class FollowerOf<2, 1>;
template class FollowerOf<Eigen::Dynamic, Eigen::Dynamic>;

std::string to_string(Kind kind) {
  return name_of<Kind::unsettled>(kind, "periodic", "quasi-periodic", "irregular", "slides", "stuck",
                                  "grows without bound", "unsettled");
}

Interval wilson(long count, long total) {
  constexpr double z = 1.959963984540054;  // the quantile of 97.5 % of the normal distribution
  const auto n = static_cast<double>(total);
  const double share = static_cast<double>(count) / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  // Nothing but rounding keeps the ends of the certain shares from being exact.
  return {count == 0 ? 0 : middle - half, count == total ? 1 : middle + half};
}

}  // namespace stickslip::numeric::attractors
