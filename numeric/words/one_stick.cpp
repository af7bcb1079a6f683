#include "numeric/words/one_stick.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/families/one_stick_closing.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using namespace zeros;
using families::NamedBall;

namespace {

constexpr long search_bits = 64;
constexpr long guess_bits = 128;

// The question in the variables of one_stick_closing.hpp, at the working precision.
template <int N>
struct Problem {
  Problem(const WordQuestion& q, const Word& word, long n)
      : oscillator(model::oscillator<Ball>(parameters_as<Ball>(q.data))),
        phases(word.phases()),
        periods(n),
        whole(Rational(Rational(n) / q.data.omega).get_den() == 1),
        closing(data(q, n), !whole) {}

  // Whether its first phase is an overshoot: then the motion is the mirror image of what closing.hpp knows.
  [[nodiscard]] bool is_mirrored() const { return phases.front() == PhaseKind::overshoot; }

  model::Oscillator<Ball> oscillator;
  std::vector<PhaseKind> phases;  // the stick last
  long periods;
  bool whole;  // n/omega is a whole number
  families::OneStick<N, families::Datum::friction> closing;

 private:
  [[nodiscard]] families::OneStickData<Ball> data(const WordQuestion& q, long n) {
    const auto stick = std::find(phases.begin(), phases.end(), PhaseKind::stick);
    std::rotate(phases.begin(), stick + 1, phases.end());
    families::OneStickData<Ball> result{families::overshooting_data<Ball>(q.data), Ball(q.ur)};
    result.d.Theta *= Ball(n);
    if (is_mirrored()) {
      result.d.V = -result.d.V;
    }
    return result;
  }
};

// The motion of a zero, nearly.
template <int N>
Guess guess_of(const Problem<N>& problem, const families::OneStickMotion<N>& motion) {
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
  for (int i = 0; i < N; ++i) {
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

template <int N>
std::vector<NamedBall> named(const Problem<N>& problem, const Box<N>& x) {
  const Box<N> times = families::times<Ball, N>(problem.closing.exact.d.Theta, x);
  std::vector<NamedBall> where{{"tau", times(0)}};
  if (N == 2) {
    where.push_back({"tau1", times(N - 1)});
  }
  return where;
}

// n/omega a whole number: why is in one_stick.hpp.
template <int N>
bool lasts_too_short(const Problem<N>& problem, const Box<N>& X) {
  const Box<N> times = families::times<Ball, N>(problem.closing.exact.d.Theta, X);
  return problem.whole && std::all_of(times.begin(), times.end(),
                                      [](const Ball& time) { return (time - Ball::pi()).is_negative(); });
}

// How the durations of a motion divide the period, for a problem's unknowns.
template <int N>
Box<N> shares(const Problem<N>& problem, const Motion& motion) {
  const auto lasting = [&](PhaseKind kind) {
    return std::find_if(motion.phases.begin(), motion.phases.end(),
                        [kind](const Phase& phase) { return phase.kind == kind; })
        ->duration;
  };
  const Ball tau = lasting(problem.phases[0]);
  Box<N> x;
  x(0) = tau / problem.closing.exact.d.Theta;
  if (N == 2) {
    const Ball tau1 = lasting(problem.phases[1]);
    x(0) = (tau + tau1) / problem.closing.exact.d.Theta;
    x(N - 1) = tau1 / (tau + tau1);
  }
  return x;
}

// The zero as an orbit, or left open; outside the domain it is neither.
template <int N>
void conclude(const WordQuestion& q, const Word& word, long periods, const FoundZero<N>& found,
              WordList& list) {
  using families::Place;
  const auto recipe = [&] { return Problem<N>(q, word, periods).closing; };
  const auto zero = families::refined<N, families::Datum::friction>(recipe, found, guess_bits);
  if (zero.place == Place::outside) {
    return;
  }
  const WorkingPrecision scope(guess_bits);
  const Problem<N> problem(q, word, periods);
  const auto leave_open = [&](const std::string& reason) {
    list.unresolved.push_back({named<N>(problem, zero.x), reason});
  };
  const auto motion = zero.f.motion(zero.x);
  if (zero.place == Place::at_edge || !motion) {
    return leave_open(motion ? families::no_time_at_all : families::dependent);
  }
  WordOrbit orbit = prove_word_orbit(q, guess_of<N>(problem, *motion));
  if (orbit.existence.truth != Truth::proved) {
    return leave_open(orbit.existence.reason);
  }
  if (orbit.word != word || orbit.periods != periods ||
      !contains<N>(found.unique, shares<N>(problem, orbit.orbit.motion))) {
    return leave_open("the motion that was proved near a zero may be another one");
  }
  list.orbits.push_back(std::move(orbit));
}

template <int N>
WordList all_with_times(const WordQuestion& q, const Word& word, long periods, const SearchLimits& limits) {
  WordList list;
  SearchResult<N> result;
  {
    const WorkingPrecision scope(search_bits);
    const Problem<N> problem(q, word, periods);
    Cell<N> all;
    all.lower.fill(0);
    all.upper.fill(1);
    result = search<N>(
        all,
        [&](const Box<N>& X) {
          return lasts_too_short(problem, X) ? std::nullopt : families::contract(problem.closing, X);
        },
        [&](const Box<N>& X) { return families::decide(problem.closing, X); }, limits);
    for (const UnresolvedBox<N>& open : result.unresolved) {
      list.unresolved.push_back({named<N>(problem, open.box), open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const FoundZero<N>& found : result.zeros) {
    conclude<N>(q, word, periods, found, list);
  }
  return list;
}

}  // namespace

WordList all_with_one_stick(const WordQuestion& question, const Word& word, long periods) {
  return word.size() == 2
             ? all_with_times<1>(question, word, periods, {.smallest = 0x1p-24, .cells = 20000})
             : all_with_times<2>(question, word, periods, {.smallest = 0x1p-30, .cells = 1000000});
}

}  // namespace stickslip::numeric::words
