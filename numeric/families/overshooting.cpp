#include "numeric/families/overshooting.hpp"

#include <algorithm>
#include <variant>

#include "core/error.hpp"
#include "numeric/families/one_stick_closing.hpp"
#include "numeric/families/overshooting_strip.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

constexpr long search_bits = 64;
constexpr long guess_bits = 128;
constexpr SearchLimits limits{.smallest = 0x1p-30, .cells = 1000000};

std::vector<NamedBall> named(const Box<2>& times) {
  return {{"tau", times(0)}, {"tau1", times(1)}};
}

// A proved zero, refined and looked at: nothing when it lies outside the triangle. recipe(): the problem at
// the working precision.
template <Datum G, class Recipe>
std::variant<std::monostate, Candidate, Unresolved> conclude(const ExactParameters& a, const Recipe& recipe,
                                                             const FoundZero<2>& found) {
  const RefinedZero<OneStick<2, G>> zero = refined<OneStick<2, G>>(recipe, found, guess_bits);
  if (zero.place == Place::outside) {
    return {};
  }
  const std::vector<NamedBall> where = named(times<Ball, 2>(zero.f.problem.exact.d.Theta, zero.x));
  if (zero.place == Place::at_edge) {
    return Unresolved{where, no_time_at_all};
  }
  const std::optional<ClosedTimes<2>> motion = motion_at(zero.f, zero.x);
  if (!motion) {
    return Unresolved{where, dependent};
  }
  const Motion guess = compose(model::oscillator<Ball>(parameters_as<Ball>(a)), motion->phi, motion->Z0,
                               {{PhaseKind::slip, motion->times(0)},
                                {PhaseKind::overshoot, motion->times(1)},
                                {PhaseKind::stick, motion->stick}});
  const auto is_same = [unique = found.unique](const Motion& other) {
    const Ball &tau1 = other.phases[1].duration, total = other.phases[0].duration + tau1;
    return unique(0).contains(total / period(other)) && unique(1).contains(tau1 / total);
  };
  constexpr bool phi_given = G == Datum::phase;
  return Candidate{OvershootingClosing{phi_given, !phi_given}, guess, where, is_same, 0, phi_given ? -1 : 5};
}

// omega_j = k omega, k > 1: why boxes that reach T = 0 stay open. There the odd row of mode j is -2 eta
// us/omega_j sin(mu_j) sin(nu_j) with mu_j + nu_j = k pi, to third order in T: it has double zeros where tau
// is a multiple of Theta/k.
std::string reason_at_end(const ExactParameters& a) {
  const Resonances found = resonances(a);
  const long k = found.first > 1 ? found.first : found.second;
  return k > 1 ? "at $T = 0$, $tau$ a multiple of $Theta/" + std::to_string(k) +
                     "$, the equations have multiple zeros, for $" + std::to_string(k) +
                     " omega$ is a natural frequency"
               : "";
}

template <Datum G>
Found search_all(const ExactParameters& a, const Rational& given) {
  const auto recipe = [&] {
    return OneStick<2, G>({overshooting_data<Ball>(a), Ball(given)}, a.omega.get_num() != 1);
  };
  Found list;
  SearchResult<2> result;
  {
    const WorkingPrecision scope(search_bits);
    const OneStick<2, G> f = recipe();
    result = search<2>(
        {{0, 0}, {1, 1}}, [&](const Box<2>& X) { return contract(f, X); },
        [&](const Box<2>& X) { return decide(f, X); }, limits);
    const std::string at_end = reason_at_end(a);
    for (const UnresolvedBox<2>& open : result.unresolved) {
      const bool reaches_end = !at_end.empty() && !(open.box(0) - Ball(1)).is_negative();
      list.unresolved.push_back(
          {named(times<Ball, 2>(f.exact.d.Theta, open.box)), reaches_end ? at_end : open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const auto& concluded : parallel_map(
           result.zeros.size(), [&](std::size_t i) { return conclude<G>(a, recipe, result.zeros[i]); })) {
    if (const auto * orbit = std::get_if<Candidate>(&concluded)) {
      list.candidates.push_back(*orbit);
    } else if (const auto * open = std::get_if<Unresolved>(&concluded)) {
      list.unresolved.push_back(*open);
    }
  }
  return list;
}

Found search_overshooting(const Given<Rational>& given) {
  const ExactParameters& a = given.data;
  require_stick_slip_domain(a);
  if (given.phi) {
    return search_all<Datum::phase>(a, *given.phi);
  }
  if (a.p == 0) {
    throw DomainError("p", stickslip::to_string(a.p),
                      "p > 0 when ur is given and the load's phase is unknown");
  }
  if (*given.ur <= 0) {
    throw DomainError("ur", stickslip::to_string(*given.ur), "ur > 0");
  }
  return search_all<Datum::friction>(a, *given.ur);
}

}  // namespace

Vector OvershootingClosing::unknowns(const Motion& motion) const {
  if (motion.phases.size() != 3) {
    throw InternalError("an overshooting motion of other phases than a slip, an overshoot and a stick");
  }
  const model::Parameters<Ball>& a = motion.oscillator.data;
  const Phase& slip = motion.phases[0];
  const Ball half_T = motion.phases[2].duration / Ball(2);
  const Ball u = slip.Z(0) - a.chi * slip.Z(1);
  const Ball v = slip.Z(2) - a.chi * a.V;
  const auto [sine, cosine] = sin_cos(half_T);
  Vector x(takes_phi ? 5 : 6);
  x.head<5>() << slip.duration, motion.phases[1].duration, slip.Z(1) - a.V * half_T, u * sine + v * cosine,
      u * cosine - v * sine;
  if (!takes_phi) {
    x(5) = slip.load;
  }
  return x;
}

const Family& overshooting() {
  static const Family family{
      .name = "overshooting",
      .title = "Overshooting orbits: slip to $tau$, overshoot to $tau + tau1$, stick to $Theta$",
      .phases = {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick},
      .durations = {"tau", "tau1", "T"},
      .requirements = joined(
          {sound_data({"tau", "tau1", "T"}),
           slip_after_stick(),
           {{"18", "$z2'(tau) = V$, $chi eta (z2B - z1B) - p cos(omega tau + phi) + eta (ur + us) < 0$",
             Quantity::beyond_minus_ur, 1},
            overshoots(1, "$z2' > V$ for $tau < t < tau + tau1$")},
           sticks_at("19", 2, "(tau + tau1)"),
           {{"11.upper",
             "$chi eta (x2 - x1) - p cos(omega t + phi) < eta ur$ for $tau + tau1 < t < Theta$",
             Quantity::below_ur,
             2,
             true,
             {false, true}},
            {"11.lower", "$chi eta (x2 - x1) - p cos(omega t + phi) > -eta ur$ for $tau + tau1 < t < Theta$",
             Quantity::above_minus_ur, 2, true}}}),
      .why_no_phi = "",
      .why_no_ur = "",
      .why_one_of_phi_ur =
          "overshooting orbits need exactly one of phi and ur: with phi, ur is a result; with ur, phi is",
      .searched =
          [](const OrbitQuestion& q) {
            return std::string("$tau >= 0$, $tau1 >= 0$, $tau + tau1 <= Theta$ ") +
                   (q.phi ? "at this $phi$" : "for every $phi$ that gives this $ur$");
          },
      .search = search_overshooting,
      .strips = overshooting_strips,
      .judges = &atlas::overshooting_judges};
  return family;
}

}  // namespace stickslip::numeric::families
