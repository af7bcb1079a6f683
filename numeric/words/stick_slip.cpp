#include "numeric/words/stick_slip.hpp"

#include <algorithm>
#include <cmath>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/words/stick_slip_rows.hpp"
#include "numeric/zeros/elimination.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::words {

using namespace motion;
using namespace zeros;

namespace {

constexpr int R = stick_slip_rows;
constexpr int C = stick_slip_columns;
constexpr int states = 3;  // columns to be eliminated
constexpr long search_bits = 64;
constexpr long guess_bits = 128;
constexpr SearchLimits limits{.smallest = 0x1p-24, .cells = 6000};

// A stick of n whole turns then brings z1 and z1' back.
constexpr const char * dependent_at_origin =
    "at $tau = 0$ the equations for the state are dependent, for $n/omega$ is a whole number";
constexpr const char * dependent = "the equations for the state may be dependent";

using BoxJet = scalars::Jet<Ball, 1>;

// The question at the working precision; x in [0, 1] is the share of the slip in n periods.
struct Problem {
  model::Oscillator<Ball> oscillator;
  Ball ur, total;

  Problem(const WordQuestion& q, long periods)
      : oscillator(model::oscillator<Ball>(parameters_as<Ball>(q.data))),
        ur(q.ur),
        total(Ball(2 * periods) * Ball::pi() / oscillator.data.omega) {}

  template <class T>
  [[nodiscard]] StickSlipRows<T> rows(const T& x) const {
    return rows_of_stick_slip<T, Ball>(oscillator, ur, total, T(T(total) * x));
  }
};

// Of eliminated rows: the vector product of the last two in the columns cos phi, sin phi, 1.
template <class T>
Eigen::Matrix<T, 3, 1> direction(const StickSlipRows<T>& m) {
  const auto minor = [&m](int j, int k) { return T(m(3, j) * m(4, k) - m(3, k) * m(4, j)); };
  return {minor(4, 5), minor(5, 3), minor(3, 4)};
}

template <class T>
T eliminant(const StickSlipRows<T>& m) {
  const Eigen::Matrix<T, 3, 1> n = direction<T>(m);
  return n(0) * n(0) + n(1) * n(1) - n(2) * n(2);
}

// Whether a row allows some cos phi and sin phi: |1's part| is at most the length of the other two.
bool is_possible(const StickSlipRows<BoxJet>& m) {
  for (const int i : {3, 4}) {
    const Ball &a = m(i, 3).value, &b = m(i, 4).value, &c = m(i, 5).value;
    if ((c * c - a * a - b * b).is_positive()) {
      return false;
    }
  }
  return true;
}

// For krawczyk.hpp: the eliminant with rows combined as fits a box. Not finite where a pivot may vanish.
struct Eliminant {
  Problem problem;
  Eigen::Matrix<Ball, R, R> combinations;

  template <class T>
  [[nodiscard]] StickSlipRows<T> rows(const T& x) const {
    return combined_rows<T, R, C>(combinations, problem.rows<T>(x));
  }
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 1, 1> operator()(const Eigen::Matrix<T, 1, 1>& x) const {
    StickSlipRows<T> m = rows<T>(x(0));
    Eigen::Matrix<T, 1, 1> value;
    value(0) = eliminate<T, R, C>(m, 0, states) ? eliminant<T>(m) : T(T(1) / T(0));
    return value;
  }
};

std::optional<Eigen::Matrix<Ball, R, R>> combinations_for(const StickSlipRows<Ball>& at_m) {
  const Eigen::Matrix<Ball, R, states + 1> part = at_m.leftCols<states + 1>();
  return row_combinations<R, states + 1>(part);
}

// With combinations that lose no row.
std::optional<Eliminant> eliminant_near(const Problem& problem, const Box<1>& X) {
  const auto combinations = combinations_for(problem.rows<Ball>(X(0).midpoint()));
  if (!combinations || !is_invertible<R>(*combinations)) {
    return std::nullopt;
  }
  return Eliminant{problem, *combinations};
}

// The part of X that may hold a zero. Rows that hold still do when they are combined.
std::optional<Box<1>> contract(const Problem& problem, const Box<1>& X) {
  const Box<1> m = midpoint<1>(X);
  StickSlipRows<Ball> at_m = problem.rows<Ball>(m(0));
  const auto combinations = combinations_for(at_m);
  if (!combinations) {
    return X;
  }
  StickSlipRows<BoxJet> over =
      combined_rows<BoxJet, R, C>(*combinations, problem.rows<BoxJet>(BoxJet::variable(X(0), 0)));
  at_m = combined_rows<Ball, R, C>(*combinations, at_m);
  sharpen<R, C, 1>(over, at_m, X - m);
  if (!eliminate<BoxJet, R, C>(over, 0, states)) {
    return X;
  }
  if (!is_possible(over)) {
    return std::nullopt;
  }
  if (!eliminate<Ball, R, C>(at_m, 0, states)) {
    return X;
  }
  const BoxJet g = eliminant<BoxJet>(over);
  if (g.value.is_nonzero()) {
    return std::nullopt;
  }
  Eigen::Matrix<Ball, 1, 1> slope;
  slope(0) = g.partials[0];
  return contract_by<1>(eliminant<Ball>(at_m), slope, m, X);
}

Decision<1> decide(const Problem& problem, const Box<1>& X) {
  const auto f = eliminant_near(problem, X);
  if (!f) {
    return {std::nullopt, false, dependent};
  }
  const Decision<1> decision = KrawczykDecider<1, Eliminant>{*f}(X);
  if (decision.found) {
    StickSlipRows<Ball> m = f->rows<Ball>(decision.found->zero(0));
    if (!eliminate<Ball, R, C>(m, 0, states) || !direction<Ball>(m)(2).is_nonzero()) {
      return {std::nullopt, false, "the load's phase may be undetermined"};
    }
  }
  return decision;
}

// The motion of a zero, nearly.
Guess guess_of(const Problem& problem, StickSlipRows<Ball> m, const Ball& tau, long periods) {
  const Eigen::Matrix<Ball, 3, 1> n = direction<Ball>(m);
  const Ball c = n(0) / n(2);
  const Ball s = n(1) / n(2);
  Eigen::Matrix<Ball, states, 1> u;
  for (int k = states - 1; k >= 0; --k) {
    Ball sum = m(k, 3) * c + m(k, 4) * s + m(k, 5);
    for (int j = k + 1; j < states; ++j) {
      sum += m(k, j) * u(j);
    }
    u(k) = -sum / m(k, k);
  }
  const model::Oscillator<Ball>& o = problem.oscillator;
  const double t = std::atan2(s.approximate(), c.approximate()) / o.data.omega.approximate();
  const model::Vector4<Ball> Z0(u(0), u(1), u(2), o.data.V);
  const Motion motion = compose(o, o.data.omega * Ball(t), Z0,
                                {{PhaseKind::slip, tau}, {PhaseKind::stick, problem.total - tau}});
  Guess guess{{}, periods};
  for (const Phase& phase : motion.phases) {
    guess.events.push_back({t + phase.start.approximate(), Ball(phase.Z(0) + o.d0(0)).approximate(),
                            Ball(phase.Z(1) + o.d0(1)).approximate(), phase.Z(2).approximate(), phase.kind});
  }
  return guess;
}

// The zero as an orbit, or left open; outside the domain it is neither.
void conclude(const WordQuestion& q, long periods, const FoundZero<1>& found, WordList& list) {
  const auto near = eliminant_near(Problem(q, periods), found.zero);
  const auto here = [&] { return Eliminant{Problem(q, periods), near->combinations}; };
  const Box<1> x = refine<1>(here, found.zero, guess_bits);
  const WorkingPrecision scope(guess_bits);
  const Eliminant f = here();
  const Ball tau = f.problem.total * x(0);
  const families::Place at = families::place(x(0));
  if (at == families::Place::outside) {
    return;
  }
  if (at == families::Place::at_edge) {
    list.unresolved.push_back({tau, families::no_time_at_all});
    return;
  }
  StickSlipRows<Ball> m = f.rows<Ball>(x(0));
  if (!eliminate<Ball, R, C>(m, 0, states)) {
    list.unresolved.push_back({tau, dependent});
    return;
  }
  WordOrbit orbit = prove_word_orbit(q, guess_of(f.problem, m, tau, periods));
  if (orbit.existence.truth != Truth::proved) {
    list.unresolved.push_back({tau, orbit.existence.reason});
    return;
  }
  if (!found.unique(0).contains(orbit.orbit.motion.phases[0].duration / f.problem.total)) {
    list.unresolved.push_back({tau, "the motion that was proved near a zero may be another one"});
    return;
  }
  list.orbits.push_back(std::move(orbit));
}

}  // namespace

WordList all_stick_slip_orbits(const WordQuestion& question, long periods) {
  require_word_domain(question);
  if (question.data.V <= 0) {
    throw DomainError("V", stickslip::to_string(question.data.V),
                      "V > 0 for a complete list of orbits with a stick phase");
  }
  WordList list;
  SearchResult<1> result;
  {
    const WorkingPrecision scope(search_bits);
    const Problem problem(question, periods);
    result = search<1>(
        {{0}, {1}}, [&](const Box<1>& X) { return contract(problem, X); },
        [&](const Box<1>& X) { return decide(problem, X); }, limits);
    const bool whole = Rational(Rational(periods) / question.data.omega).get_den() == 1;
    for (const UnresolvedBox<1>& open : result.unresolved) {
      const bool at_origin = whole && open.box(0).contains_zero();
      list.unresolved.push_back({problem.total * open.box(0), at_origin ? dependent_at_origin : open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const FoundZero<1>& found : result.zeros) {
    conclude(question, periods, found, list);
  }
  return list;
}

}  // namespace stickslip::numeric::words
