#include "numeric/families/overshooting.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "core/error.hpp"
#include "numeric/families/overshooting_exclusion.hpp"
#include "numeric/families/overshooting_strip.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

constexpr long search_bits = 64;
constexpr long guess_bits = 128;
constexpr SearchLimits limits{.smallest = 0x1p-20, .cells = 30000};

constexpr const char * dependent =
    "the amplitudes cannot be eliminated: the equations for them may be dependent";

using AtPhase = OvershootingAtPhase;
using AtFriction = OvershootingAtFriction;

// The functions with their rows combined as fits the middle of the box; nothing when they look dependent
// there.
template <class Family>
std::optional<Eliminated<Family>> eliminated_near(const Family& f, const Box<2>& X) {
  const auto combinations =
      row_combinations<Family::rows, Family::unknowns + 1>(all_rows<Ball>(f, midpoint<2>(X)));
  return combinations ? std::optional(Eliminated<Family>{f, *combinations}) : std::nullopt;
}

// Exactly one orbit in a box that contains X, or none in X.
template <class Family>
Decision<2> decide(const Family& f, const Box<2>& X) {
  const auto eliminated = eliminated_near(f, X);
  if (!eliminated || !is_invertible<Family::rows>(eliminated->combinations)) {
    return {std::nullopt, false, dependent};
  }
  return KrawczykDecider<2, Eliminated<Family>>{*eliminated}(X);
}

// The part of X that may hold an orbit: by the odd rows, then by all of them.
template <class Family>
std::optional<Box<2>> contract(const Family& f, const Box<2>& X) {
  constexpr int R = Family::rows;
  constexpr int C = Family::unknowns + 1;
  const Box<2> m = midpoint<2>(X);
  const model::OvershootingData<BoxJet> lifted = model::lift<BoxJet>(f.data);
  const Times<BoxJet> t = times<BoxJet>(lifted.Theta, variables<Ball, 2>(X));
  const Times<Ball> t_m = times<Ball>(f.data.Theta, m);
  const OddRows<Family> odd{f.template odd<BoxJet>(lifted, t), f.template odd<Ball>(f.data, t_m)};
  std::optional<Box<2>> rest = contract_by_odd_rows(odd, m, X);
  if (!rest) {
    return rest;
  }
  RowsOf<BoxJet, Family> over;
  RowsOf<Ball, Family> at_m;
  over.template topRows<2>() = odd.over;
  at_m.template topRows<2>() = odd.at_m;
  over.template bottomRows<R - 2>() = f.template others<BoxJet>(lifted, t);
  at_m.template bottomRows<R - 2>() = f.template others<Ball>(f.data, t_m);
  const auto combinations = row_combinations<R, C>(at_m);
  if (!combinations) {
    return rest;
  }
  over = combined_rows<BoxJet, R, C>(*combinations, over);
  at_m = combined_rows<Ball, R, C>(*combinations, at_m);
  sharpen<R, C, 2>(over, at_m, X - m);
  if (!eliminate<BoxJet, R, C>(over, 0, 3)) {
    return rest;
  }
  if constexpr (std::is_same_v<Family, OvershootingAtFriction>) {
    if (!is_possible(over)) {
      return std::nullopt;
    }
  }
  if (!eliminate<BoxJet, R, C>(over, 3, C - 1) || !eliminate<Ball, R, C>(at_m, 0, C - 1)) {
    return rest;
  }
  const Eigen::Matrix<BoxJet, 2, 1> jets = f.template functions<BoxJet>(over);
  const Box<2> g = f.template functions<Ball>(at_m);
  const BallMatrix<2> slope = jacobian<Ball, 2, 2>(jets);
  for (int i = 0; i < 2 && rest; ++i) {
    rest = jets(i).value.is_nonzero() ? std::nullopt : contract_by<2>(g(i), slope.row(i), m, *rest);
  }
  const std::optional<Box<2>> K = rest ? krawczyk_image<2>(m, g, slope, X) : std::nullopt;
  return K ? intersection<2>(*K, *rest) : rest;
}

Ball angle(const Ball& sine, const Ball& cosine) {
  Ball result;
  arb_atan2(result.raw(), sine.raw(), cosine.raw(), WorkingPrecision::bits());
  return result;
}

Ball phase_of(const AtPhase& f, const Box<3>& /*u*/, const Times<Ball>& /*t*/) {
  return f.phi;
}
Ball phase_of(const AtFriction& f, const Box<5>& u, const Times<Ball>& t) {
  const Ball phi = angle(u(4), u(3)) - f.data.omega * (t.tau + t.tau1) / Ball(2);
  const Ball turn = Ball(2) * Ball::pi();
  return phi - turn * Ball(std::floor((phi / turn).approximate() + 0.5));
}

std::vector<NamedBall> named(const Times<Ball>& t) {
  return {{"tau", t.tau}, {"tau1", t.tau1}};
}

Closing equations(const AtPhase&) {
  return OvershootingClosing{true, false};
}
Closing equations(const AtFriction&) {
  return OvershootingClosing{false, true};
}

// A proved zero of the two functions, refined and looked at: nothing when it lies outside the triangle.
// recipe(): the family at the working precision.
template <class Recipe>
std::variant<std::monostate, Candidate, Unresolved> conclude(const ExactParameters& a, const Recipe& recipe,
                                                             const FoundZero<2>& found) {
  using Function = Eliminated<std::invoke_result_t<Recipe>>;
  const Function near = *eliminated_near(recipe(), found.zero);
  const auto here = [&] { return Function{recipe(), near.combinations}; };
  const Box<2> sw = refine<2>(here, found.zero, guess_bits);
  const Function f = here();
  const model::OvershootingData<Ball>& d = f.family.data;
  const Times<Ball> t = times<Ball>(d.Theta, sw);
  for (const Place side : {place(sw(0)), place(sw(1))}) {
    if (side == Place::outside) {
      return {};
    }
  }
  if (place(sw(0)) == Place::at_edge || place(sw(1)) == Place::at_edge) {
    return Unresolved{named(t), no_time_at_all};
  }
  auto rows = f.template rows<Ball>(sw);
  if (!eliminate<Ball, Function::R, Function::C>(rows, 0, Function::C - 1)) {
    return Unresolved{named(t), dependent};
  }
  const auto u = back_substituted<Ball, Function::R, Function::C>(rows);
  const Ball T = d.Theta - t.tau - t.tau1;
  const Motion guess =
      compose(model::oscillator<Ball>(parameters_as<Ball>(a)), phase_of(f.family, u, t),
              model::overshooting_start<Ball>(d, T, u(0), u(1), u(2)),
              {{PhaseKind::slip, t.tau}, {PhaseKind::overshoot, t.tau1}, {PhaseKind::stick, T}});
  const auto is_same = [unique = found.unique](const Motion& motion) {
    const Ball &tau1 = motion.phases[1].duration, total = motion.phases[0].duration + tau1;
    return unique(0).contains(total / period(motion)) && unique(1).contains(tau1 / total);
  };
  return Candidate{equations(f.family),
                   guess,
                   named(t),
                   is_same,
                   0,
                   std::is_same_v<std::invoke_result_t<Recipe>, AtPhase> ? -1 : 5};
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

template <class Recipe>
Found search_all(const ExactParameters& a, const Recipe& recipe) {
  Found list;
  SearchResult<2> result;
  {
    const WorkingPrecision scope(search_bits);
    const auto f = recipe();
    const bool vanishes_at_origin = a.omega.get_num() == 1;
    const auto contractor = [&](const Box<2>& X) -> std::optional<Box<2>> {
      if (vanishes_at_origin && X(0).contains_zero() && excluded_at_origin(f, X)) {
        return std::nullopt;
      }
      return contract(f, X);
    };
    result = search<2>(
        {{0, 0}, {1, 1}}, contractor, [&](const Box<2>& X) { return decide(f, X); }, limits);
    const std::string at_end = reason_at_end(a);
    for (const UnresolvedBox<2>& open : result.unresolved) {
      const Times<Ball> t = times<Ball>(f.data.Theta, open.box);
      const bool reaches_end = !at_end.empty() && !(open.box(0) - Ball(1)).is_negative();
      list.unresolved.push_back({named(t), reaches_end ? at_end : open.reason});
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.zero(0).approximate() < y.zero(0).approximate(); });
  for (const auto& concluded : parallel_map(
           result.zeros.size(), [&](std::size_t i) { return conclude(a, recipe, result.zeros[i]); })) {
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
    return search_all(a, [&] { return AtPhase{overshooting_data<Ball>(a), Ball(*given.phi)}; });
  }
  if (a.p == 0) {
    throw DomainError("p", stickslip::to_string(a.p),
                      "p > 0 when ur is given and the load's phase is unknown");
  }
  if (*given.ur <= 0) {
    throw DomainError("ur", stickslip::to_string(*given.ur), "ur > 0");
  }
  return search_all(a, [&] { return AtFriction{overshooting_data<Ball>(a), Ball(*given.ur)}; });
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
      .strips = overshooting_strips};
  return family;
}

}  // namespace stickslip::numeric::families
