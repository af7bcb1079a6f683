#include "numeric/words/by_durations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/families/overshooting.hpp"
#include "numeric/words/two_sticks.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using namespace zeros;
using families::ClosedTimes;
using families::Datum;
using families::NamedBall;
using families::OneStick;

namespace {

constexpr long search_bits = 64;
constexpr long guess_bits = 128;

// The phases in their order, a stick the last.
std::vector<PhaseKind> from_first_stick(const Word& word) {
  std::vector<PhaseKind> phases = word.phases();
  const auto stick = std::find(phases.begin(), phases.end(), PhaseKind::stick);
  std::rotate(phases.begin(), stick + 1, phases.end());
  return phases;
}

template <int N>
OneStick<N, Datum::friction> closing_of(const WordQuestion& q, const std::vector<PhaseKind>& phases, long n,
                                        const OneStick<N, Datum::friction> * /*kind*/) {
  families::OneStickData<Ball> data{families::overshooting_data<Ball>(q.data), Ball(q.ur)};
  data.d.Theta *= Ball(n);
  if (phases.front() == PhaseKind::overshoot) {
    data.d.V = -data.d.V;
  }
  return {data, Rational(Rational(n) / q.data.omega).get_den() != 1};
}
TwoSticks closing_of(const WordQuestion& q, const std::vector<PhaseKind>& phases, long n,
                     const TwoSticks * /*kind*/) {
  const model::Parameters<Ball> a = parameters_as<Ball>(q.data);
  const auto sign = [&](std::size_t k) { return phases[k] == PhaseKind::slip ? 1 : -1; };
  return TwoSticks({a,
                    model::modes<Ball>(a.chi, a.eta),
                    Ball(q.ur),
                    Ball(2 * n) * Ball::pi() / a.omega,
                    {sign(0), sign(2)}});
}

template <int N>
Ball total_of(const OneStick<N, Datum::friction>& closing) {
  return closing.exact.d.Theta;
}
Ball total_of(const TwoSticks& closing) {
  return closing.exact.total;
}

// The question in the variables of families/linear_closing.hpp, at the working precision.
template <class P>
struct Problem {
  Problem(const WordQuestion& q, const Word& word, long n)
      : oscillator(model::oscillator<Ball>(parameters_as<Ball>(q.data))),
        phases(from_first_stick(word)),
        periods(n),
        whole(Rational(Rational(n) / q.data.omega).get_den() == 1),
        closing(closing_of(q, phases, n, static_cast<const P *>(nullptr))) {}

  // Whether the motion is the mirror image of what one_stick_closing.hpp knows.
  [[nodiscard]] bool is_mirrored() const {
    return !std::is_same_v<P, TwoSticks> && phases.front() == PhaseKind::overshoot;
  }

  model::Oscillator<Ball> oscillator;
  std::vector<PhaseKind> phases;  // a stick last
  long periods;
  bool whole;  // n/omega is a whole number
  P closing;
};

// Half of the motions of a word that is its own rotation by two phases say all: the first two phases last no
// longer than the others.
template <class P>
bool is_repeated(const Problem<P>& problem) {
  return std::is_same_v<P, TwoSticks> && problem.phases[0] == problem.phases[2];
}

// The motion of a zero, nearly.
template <class P>
Guess guess_of(const Problem<P>& problem, const ClosedTimes<P::times>& motion) {
  const model::Oscillator<Ball>& o = problem.oscillator;
  model::Vector4<Ball> Z0 = motion.Z0;
  Ball phi = motion.phi;
  if (problem.is_mirrored()) {
    phi += Ball::pi();
    Z0 = -Z0;
    Z0(0) -= Ball(2) * o.d0(0);
    Z0(1) -= Ball(2) * o.d0(1);
  }
  std::vector<Leg> legs;
  for (int i = 0; i < P::times; ++i) {
    legs.push_back({problem.phases[static_cast<std::size_t>(i)], motion.times(i)});
  }
  legs.push_back({PhaseKind::stick, motion.stick});
  Guess guess{{}, problem.periods};
  const double t = Ball(phi / o.data.omega).approximate();
  for (const Phase& phase : compose(o, phi, Z0, legs).phases) {
    guess.events.push_back({t + phase.start.approximate(), Ball(phase.Z(0) + o.d0(0)).approximate(),
                            Ball(phase.Z(1) + o.d0(1)).approximate(), phase.Z(2).approximate(), phase.kind});
  }
  return guess;
}

// How long the phases last but the last stick.
template <int N>
Box<N> durations(const Ball& total, const Box<N>& x, const OneStick<N, Datum::friction> * /*kind*/) {
  return families::times<Ball, N>(total, x);
}
Box<3> durations(const Ball& total, const Box<3>& x, const TwoSticks * /*kind*/) {
  const Ball first = total * x(0);
  return {first * x(1), first * (Ball(1) - x(1)), (total - first) * x(2)};
}
template <class P>
Box<P::times> durations(const Problem<P>& problem, const Box<P::times>& x) {
  return durations(total_of(problem.closing), x, static_cast<const P *>(nullptr));
}

template <class P>
std::vector<NamedBall> named(const Problem<P>& problem, const Box<P::times>& x) {
  constexpr std::array<const char *, 3> names{"tau", "tau1", "tau2"};
  const Box<P::times> times = durations(problem, x);
  std::vector<NamedBall> where;
  for (int i = 0; i < P::times; ++i) {
    where.push_back({names[static_cast<std::size_t>(i)], times(i)});
  }
  return where;
}

// n/omega a whole number: why is in by_durations.hpp.
template <class P>
bool lasts_too_short(const Problem<P>& problem, const Box<P::times>& X) {
  if (P::times == 3 || !problem.whole) {
    return false;
  }
  const Box<P::times> times = durations(problem, X);
  return std::all_of(times.begin(), times.end(),
                     [](const Ball& time) { return (time - Ball::pi()).is_negative(); });
}

// The unknowns of a motion whose phase number `from` is the problem's first.
template <class P>
Box<P::times> shares(const Problem<P>& problem, const Motion& motion, std::size_t from) {
  const auto lasting = [&](std::size_t k) {
    return motion.phases[(from + k) % motion.phases.size()].duration;
  };
  const Ball total = total_of(problem.closing);
  Box<P::times> x;
  if constexpr (P::times == 3) {
    const Ball first = lasting(0) + lasting(1);
    const Ball share = lasting(std::is_same_v<P, TwoSticks> ? 0 : 1) / first;
    x << first / total, share, lasting(2) / (total - first);
  } else {
    x(0) = lasting(0) / total;
    if constexpr (P::times == 2) {
      const Ball sum = lasting(0) + lasting(1);
      x << sum / total, lasting(1) / sum;
    }
  }
  return x;
}

// Whether the motion is the zero in this box.
template <class P>
bool is_in(const Problem<P>& problem, const Motion& motion, const Box<P::times>& unique) {
  const std::size_t count = motion.phases.size();
  if (count != problem.phases.size()) {
    return false;
  }
  for (std::size_t from = 0; from < count; ++from) {
    bool same = true;
    for (std::size_t k = 0; k < count; ++k) {
      same = same && motion.phases[(from + k) % count].kind == problem.phases[k];
    }
    if (same && contains<P::times>(unique, shares(problem, motion, from))) {
      return true;
    }
  }
  return false;
}

// Whether the zero in this box is that orbit, of half the word in half the periods, taken twice.
template <class P>
bool is_twice(const Problem<P>& problem, const Word& word, const WordOrbit& orbit,
              const Box<P::times>& unique) {
  if constexpr (P::times == 3) {
    if (orbit.existence.truth == Truth::proved && 2 * orbit.periods == problem.periods &&
        orbit.word.letters() + orbit.word.letters() == word.letters()) {
      const auto& phases = orbit.orbit.motion.phases;
      const Ball share =
          phases[phases[0].kind == PhaseKind::stick ? 1 : 0].duration * Ball(2) / total_of(problem.closing);
      return contains<3>(unique, {Ball(Rational(1, 2)), share, share});
    }
  }
  return false;
}

// The zero as an orbit, or left open; outside the domain it is neither.
template <class P>
void conclude(const WordQuestion& q, const Word& word, long periods, const FoundZero<P::times>& found,
              WordList& list) {
  using families::Place;
  const auto recipe = [&] { return Problem<P>(q, word, periods).closing; };
  const auto zero = families::refined<P>(recipe, found, guess_bits);
  const WorkingPrecision scope(guess_bits);
  const Problem<P> problem(q, word, periods);
  const Place half = is_repeated(problem) ? families::place(Ball(2) * zero.x(0)) : Place::inside;
  if (zero.place == Place::outside || half == Place::outside) {
    return;
  }
  const auto leave_open = [&](const std::string& reason) {
    list.unresolved.push_back({named<P>(problem, zero.x), reason});
  };
  const auto motion = motion_at(zero.f, zero.x);
  if (zero.place == Place::at_edge || !motion) {
    return leave_open(motion ? families::no_time_at_all : families::dependent);
  }
  WordOrbit orbit = prove_word_orbit(q, guess_of<P>(problem, *motion));
  if (half == Place::at_edge) {
    return is_twice(problem, word, orbit, found.unique)
               ? void()
               : leave_open("an orbit that may be a shorter one taken twice");
  }
  if (orbit.existence.truth != Truth::proved) {
    return leave_open(orbit.existence.reason);
  }
  if (orbit.word != word || orbit.periods != periods || !is_in(problem, orbit.orbit.motion, found.unique)) {
    return leave_open("the motion that was proved near a zero may be another one");
  }
  list.orbits.push_back(std::move(orbit));
}

// The side of a cell over which durations may change most: x0 is a share of all periods, x1 one of what it
// takes and x2 of what it leaves.
template <int N>
std::size_t most_felt(const Cell<N>& cell) {
  const std::array<double, 3> unit{1, cell.upper[0], 1 - cell.lower[0]};
  const auto felt = [&](std::size_t i) { return (cell.upper[i] - cell.lower[i]) * unit[i]; };
  std::size_t most = 0;
  for (std::size_t i = 1; i < N; ++i) {
    most = felt(i) > felt(most) ? i : most;
  }
  return most;
}

template <class P>
WordList all_of(const WordQuestion& q, const Word& word, long periods, const SearchLimits& limits) {
  constexpr int N = P::times;
  WordList list;
  SearchResult<N> result;
  {
    const WorkingPrecision scope(search_bits);
    const Problem<P> problem(q, word, periods);
    Cell<N> all;
    all.lower.fill(0);
    all.upper.fill(1);
    all.upper[0] = is_repeated(problem) ? 0.5 : 1;
    result = search<N>(
        all,
        [&](const Box<N>& X) {
          return lasts_too_short(problem, X) ? std::nullopt : families::contract(problem.closing, X);
        },
        [&](const Box<N>& X) { return families::decide(problem.closing, X); }, limits, most_felt<N>);
    for (const UnresolvedBox<N>& open : result.unresolved) {
      list.unresolved.push_back({named<P>(problem, open.box), open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const FoundZero<N>& found : result.zeros) {
    conclude<P>(q, word, periods, found, list);
  }
  return list;
}

}  // namespace

bool is_searched(const Word& word) {
  const auto sticks = std::count(word.letters().begin(), word.letters().end(), 'T');
  return word.size() <= 4 && sticks > 0;
}

WordList all_by_durations(const WordQuestion& question, const Word& word, long periods) {
  switch (word.size()) {
    case 2:
      return all_of<OneStick<1, Datum::friction>>(question, word, periods,
                                                  {.smallest = 0x1p-24, .cells = 20000});
    case 3:
      return all_of<OneStick<2, Datum::friction>>(question, word, periods,
                                                  {.smallest = 0x1p-30, .cells = 1000000});
    default:
      break;
  }
  const SearchLimits limits{.smallest = 0x1p-24, .cells = 4000000};
  return std::count(word.letters().begin(), word.letters().end(), 'T') == 2
             ? all_of<TwoSticks>(question, word, periods, limits)
             : all_of<OneStick<3, Datum::friction>>(question, word, periods, limits);
}

}  // namespace stickslip::numeric::words
