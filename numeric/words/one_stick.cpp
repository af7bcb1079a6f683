#include "numeric/words/one_stick.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/families/family.hpp"
#include "numeric/words/eliminated_phase.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using namespace zeros;
using families::NamedBall;

namespace {

constexpr long search_bits = 64;
constexpr long guess_bits = 128;

// The motion of a zero, nearly.
template <int N>
Guess guess_of(const ClosingProblem<N>& problem, const Box<N>& x, const StateAndLoad& begin, long periods) {
  const model::Oscillator<Ball>& o = problem.oscillator;
  const double t =
      std::atan2(begin.sine.approximate(), begin.cosine.approximate()) / o.data.omega.approximate();
  const model::Vector4<Ball> Z0(begin.z(0), begin.z(1), begin.z(2), o.data.V);
  std::vector<Leg> legs;
  Ball rest = problem.exact.total;
  const Box<N> times = problem.template times<Ball>(problem.exact.total, x);
  for (int i = 0; i < N; ++i) {
    legs.push_back({problem.phases[static_cast<std::size_t>(i)], times(i)});
    rest -= times(i);
  }
  legs.push_back({PhaseKind::stick, rest});
  Guess guess{{}, periods};
  for (const Phase& phase : compose(o, o.data.omega * Ball(t), Z0, legs).phases) {
    guess.events.push_back({t + phase.start.approximate(), Ball(phase.Z(0) + o.d0(0)).approximate(),
                            Ball(phase.Z(1) + o.d0(1)).approximate(), phase.Z(2).approximate(), phase.kind});
  }
  return guess;
}

template <int N>
std::vector<NamedBall> named(const ClosingProblem<N>& problem, const Box<N>& x) {
  const Box<N> times = problem.template times<Ball>(problem.exact.total, x);
  std::vector<NamedBall> where{{"tau", times(0)}};
  if (N == 2) {
    where.push_back({"tau1", times(N - 1)});
  }
  return where;
}

// How the durations of a motion divide the period, for a problem's unknowns.
template <int N>
Box<N> shares(const ClosingProblem<N>& problem, const Motion& motion) {
  const auto lasting = [&](PhaseKind kind) {
    return std::find_if(motion.phases.begin(), motion.phases.end(),
                        [kind](const Phase& phase) { return phase.kind == kind; })
        ->duration;
  };
  const Ball tau = lasting(problem.phases[0]);
  Box<N> x;
  x(0) = tau / problem.exact.total;
  if (N == 2) {
    const Ball tau1 = lasting(problem.phases[1]);
    x(0) = (tau + tau1) / problem.exact.total;
    x(N - 1) = tau1 / (tau + tau1);
  }
  return x;
}

// The zero as an orbit, or left open; outside the domain it is neither.
template <int N>
void conclude(const WordQuestion& q, const Word& word, long periods, const FoundZero<N>& found,
              WordList& list) {
  using families::Place;
  const auto recipe = [&] { return ClosingProblem<N>(q, word, periods); };
  const auto near = eliminant_near<N>(recipe(), found.zero);
  const auto here = [&] { return Eliminant<N>{recipe(), near->combinations}; };
  const Box<N> x = refine<N>(here, found.zero, guess_bits);
  const WorkingPrecision scope(guess_bits);
  const Eliminant<N> f = here();
  bool at_edge = false;
  for (int i = 0; i < N; ++i) {
    const Place at = families::place(x(i));
    if (at == Place::outside) {
      return;
    }
    at_edge = at_edge || at == Place::at_edge;
  }
  const auto leave_open = [&](const std::string& reason) {
    list.unresolved.push_back({named<N>(f.problem, x), reason});
  };
  const std::optional<StateAndLoad> begin = f.solved(x);
  if (at_edge || !begin) {
    return leave_open(at_edge ? families::no_time_at_all : dependent);
  }
  WordOrbit orbit = prove_word_orbit(q, guess_of<N>(f.problem, x, *begin, periods));
  if (orbit.existence.truth != Truth::proved) {
    return leave_open(orbit.existence.reason);
  }
  if (orbit.word != word || orbit.periods != periods ||
      !contains<N>(found.unique, shares<N>(f.problem, orbit.orbit.motion))) {
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
    const ClosingProblem<N> problem(q, word, periods);
    Cell<N> all;
    all.lower.fill(0);
    all.upper.fill(1);
    result = search<N>(
        all, [&](const Box<N>& X) { return contract(problem, X); },
        [&](const Box<N>& X) { return decide(problem, X); }, limits);
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
             : all_with_times<2>(question, word, periods, {.smallest = 0x1p-20, .cells = 200000});
}

}  // namespace stickslip::numeric::words
