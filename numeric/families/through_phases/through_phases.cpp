#include "numeric/families/through_phases/through_phases.hpp"

#include <algorithm>
#include <array>

#include "numeric/families/overshooting.hpp"
#include "numeric/families/through_phases/isolate.hpp"
#include "numeric/families/through_phases/two_sticks.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace zeros;

namespace {

template <class P>
constexpr bool sticks_twice = std::is_same_v<P, TwoSticks>;

// Whether n/omega is a whole number.
bool is_whole(const ThroughPhases& q) {
  return Rational(Rational(q.periods) / q.given.data.omega).get_den() == 1;
}

// Whether the motion is the mirror image of what one_stick_closing.hpp knows.
template <class P>
bool is_mirrored(const ThroughPhases& q) {
  return !sticks_twice<P> && q.phases.front() == PhaseKind::overshoot;
}

// Half of the motions of a word that is its own rotation by two phases say all: the first two phases last no
// longer than the others.
template <class P>
bool is_repeated(const ThroughPhases& q) {
  return sticks_twice<P> && q.phases[0] == q.phases[2];
}

// At the working precision.
template <class P>
P equations_of(const ThroughPhases& q) {
  if constexpr (sticks_twice<P>) {
    const model::Parameters<Ball> a = parameters_as<Ball>(q.given.data);
    const auto sign = [&](std::size_t k) { return q.phases[k] == PhaseKind::slip ? 1 : -1; };
    return P({{a, model::modes<Ball>(a.chi, a.eta), Ball(2 * q.periods) * Ball::pi() / a.omega},
              Ball(*q.given.ur),
              {sign(0), sign(2)}});
  } else {
    OneStickData<Ball> data{overshooting_data<Ball>(q.given.data),
                            Ball(q.given.phi ? *q.given.phi : *q.given.ur)};
    data.d.Theta *= Ball(q.periods);
    if (is_mirrored<P>(q)) {
      data.d.V = -data.d.V;
    }
    return P(data, !is_whole(q));
  }
}

// omega_j = k omega, k > 1: why boxes that reach T = 0 stay open. There the odd row of mode j is -2 eta
// us/omega_j sin(mu_j) sin(nu_j) with mu_j + nu_j = k pi, to third order in T: it has double zeros where tau
// is a multiple of Theta/k.
std::string reason_at_end(const ThroughPhases& q) {
  const Resonances found = q.periods == 1 ? resonances(q.given.data) : Resonances{};
  const long k = found.first > 1 ? found.first : found.second;
  return k > 1 ? "at $T = 0$, $tau$ a multiple of $Theta/" + std::to_string(k) +
                     "$, the equations have multiple zeros, for $" + std::to_string(k) +
                     " omega$ is a natural frequency"
               : "";
}

template <class P>
std::vector<NamedBall> named(const P& equations, const Box<P::times>& x) {
  constexpr std::array<const char *, 3> names{"tau", "tau1", "tau2"};
  const Box<P::times> times = equations.durations(x);
  std::vector<NamedBall> where;
  for (int i = 0; i < P::times; ++i) {
    where.push_back({names[static_cast<std::size_t>(i)], times(i)});
  }
  return where;
}

// For the search.
template <class P>
struct Searched {
  static constexpr int N = P::times;

  P equations;
  bool lawful_only;  // see the header
  std::string at_end;

  [[nodiscard]] std::optional<Box<N>> contract(const Box<N>& X) const {
    if (lawful_only) {
      const Box<N> times = equations.durations(X);
      if (std::all_of(times.begin(), times.end(),
                      [](const Ball& time) { return (time - Ball::pi()).is_negative(); })) {
        return std::nullopt;
      }
    }
    return LinearEliminant<P>::contract(equations, X);
  }
  [[nodiscard]] ZeroProof<N> decide(const Box<N>& X) const {
    return LinearEliminant<P>::decide(equations, X);
  }
  [[nodiscard]] std::optional<Unresolved> left_open(const UnresolvedBox<N>& open) const {
    const bool reaches_end = N == 2 && !at_end.empty() && !(open.box(0) - Ball(1)).is_negative();
    return Unresolved{named(equations, open.box), reaches_end ? at_end : open.reason};
  }
};

// The side of a cell that is to be halved: of three the one over which durations may change most, where x0 is
// a share of all periods, x1 one of what it takes and x2 of what it leaves. Of two x0 counts twice: all rows
// change with it, and but for one, z2'(tau) = V, with x1 only by how long the friction is turned.
template <int N>
std::size_t halved(const Cell<N>& cell) {
  if constexpr (N < 2) {
    return 0;
  }
  const std::array<double, 3> unit =
      N == 2 ? std::array<double, 3>{2, 1, 0} : std::array<double, 3>{1, cell.upper[0], 1 - cell.lower[0]};
  const auto felt = [&](std::size_t i) { return (cell.upper[i] - cell.lower[i]) * unit[i]; };
  std::size_t most = 0;
  for (std::size_t i = 1; i < N; ++i) {
    most = felt(i) > felt(most) ? i : most;
  }
  return most;
}

// The motion of a zero, nearly.
template <class P>
std::optional<Motion> motion_of(const ThroughPhases& q, const LinearEliminant<P>& f, const Box<P::times>& x) {
  const auto found = P::motion_at(f, x);
  if (!found) {
    return std::nullopt;
  }
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(q.given.data));
  model::Vector4<Ball> Z0 = found->Z0;
  Ball phi = found->phi;
  if (is_mirrored<P>(q)) {
    phi += phi.is_positive() ? -Ball::pi() : Ball::pi();
    Z0 = -Z0;
    Z0(0) -= Ball(2) * o.d0(0);
    Z0(1) -= Ball(2) * o.d0(1);
  }
  std::vector<Leg> legs;
  for (int i = 0; i < P::times; ++i) {
    legs.push_back({q.phases[static_cast<std::size_t>(i)], found->times(i)});
  }
  legs.push_back({PhaseKind::stick, found->stick});
  return compose(o, phi, Z0, legs);
}

// How long the phases of a motion last but the last one.
template <int N>
Box<N> durations_of(const Motion& motion) {
  Box<N> t;
  for (int i = 0; i < N; ++i) {
    t(i) = motion.phases[static_cast<std::size_t>(i)].duration;
  }
  return t;
}

// The zero as a motion, or left open; outside the domain it is neither.
template <class P>
Concluded<Isolated> conclude(const ThroughPhases& q, const ZeroProof<P::times>& found) {
  constexpr int N = P::times;
  const auto near = LinearEliminant<P>::near(equations_of<P>(q), found.box);
  const auto recipe = [&] { return LinearEliminant<P>{equations_of<P>(q), near->combinations}; };
  const Box<N> x = refine<N>(recipe, found.box, guess_bits);
  const LinearEliminant<P> f = recipe();
  Place all = Place::inside;
  for (const Ball& share : x) {
    all = all == Place::outside ? all : place(share) == Place::inside ? all : place(share);
  }
  const Place half = is_repeated<P>(q) ? place(Ball(2) * x(0)) : Place::inside;
  const std::vector<NamedBall> where = named(f.problem, x);
  return concluded<Isolated>(half == Place::outside ? half : all, where, [&]() -> Concluded<Isolated> {
    const std::optional<Motion> guess = motion_of<P>(q, f, x);
    if (!guess) {
      return Unresolved{where, dependent};
    }
    // At half of all it may only be a shorter one taken twice: of another each rotation is a zero.
    return Isolated{*guess, where, [unique = found.unique, half](const Motion& motion) {
                      const auto& phases = motion.phases;
                      return (half == Place::inside || phases[0].duration.overlaps(phases[2].duration)) &&
                             contains<N>(unique, P::shares(durations_of<N>(motion), period(motion)));
                    }};
  });
}

template <class P>
FoundOf<Isolated> all_of(const ThroughPhases& q, const SearchLimits& limits) {
  constexpr int N = P::times;
  Cell<N> domain;
  domain.lower.fill(0);
  domain.upper.fill(1);
  domain.upper[0] = is_repeated<P>(q) ? 0.5 : 1;
  const bool lawful_only = q.lawful && N < 3 && is_whole(q);
  return isolate<Isolated, N>(
      domain, limits,
      [&] {
        return Searched<P>{equations_of<P>(q), lawful_only, reason_at_end(q)};
      },
      [&](const ZeroProof<N>& found) { return conclude<P>(q, found); }, halved<N>);
}

}  // namespace

FoundOf<Isolated> closed_through(const ThroughPhases& q) {
  const auto sticks = std::count(q.phases.begin(), q.phases.end(), PhaseKind::stick);
  const SearchLimits three{.smallest = 0x1p-30, .cells = 1000000};
  const SearchLimits four{.smallest = 0x1p-24, .cells = 4000000};
  switch (q.phases.size()) {
    case 2:
      return all_of<OneStick<1, Datum::friction>>(q, {.smallest = 0x1p-24, .cells = 20000});
    case 3:
      return q.given.phi ? all_of<OneStick<2, Datum::phase>>(q, three)
                         : all_of<OneStick<2, Datum::friction>>(q, three);
    default:
      return sticks == 2 ? all_of<TwoSticks>(q, four) : all_of<OneStick<3, Datum::friction>>(q, four);
  }
}

}  // namespace stickslip::numeric::families
