#include "numeric/families/nonsticking.hpp"

#include <algorithm>

#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

constexpr long search_bits = 64;

// The search looks at x = (delta/pi, mu/pi). It covers [0, 1] × an interval of length 2 with a little to
// spare: then the halvings do not meet delta = pi/2 and sin(mu) = 0, where zeros with a symmetry lie and
// would be cut in two.
constexpr double delta_last = 1.0371;
constexpr double mu_first = -0.9137;
constexpr double mu_last = 1.0868;

struct Scaled {
  const TwoSlips& f;

  template <class T>
  [[nodiscard]] model::Vector2<T> operator()(const model::Vector2<T>& x) const {
    const T pi(f.pi);
    return f(model::Vector2<T>(T(pi * x(0)), T(pi * x(1))));
  }
};

void require_no_resonance(const ExactParameters& a) {
  const Resonances found = resonances(a);
  if (const long k = found.first != 0 ? found.first : found.second; k != 0) {
    throw DomainError("omega", stickslip::to_string(a.omega),
                      "no resonance: here " + std::to_string(k) + " omega is a natural frequency");
  }
}

Ball smaller(const Ball& a, const Ball& b) {
  Ball result;
  arb_min(result.raw(), a.raw(), b.raw(), WorkingPrecision::bits());
  return result;
}

// The friction at rest at the start of phase k.
Ball friction_at_start(const Motion& motion, std::size_t k) {
  return model::friction_at<Ball>(motion.oscillator.data, motion.phases[k].Z, motion.phases[k].load);
}

// The same zero modulo 2 pi in mu.
bool same_zero(const NonstickingOrbit& a, const NonstickingOrbit& b) {
  for (const int turn : {-1, 1}) {
    Box<2> shifted = b.box;
    shifted(1) += Ball(2 * turn) * Ball::pi();
    if (contains<2>(a.unique, shifted)) {
      return true;
    }
  }
  return false;
}

// A proved (delta, mu), to `digits` digits.
Box<2> refined(const ExactParameters& a, const Box<2>& zero, int digits) {
  return refine<2>([&a] { return two_slips_of(parameters_as<Ball>(a)); }, zero, bits_for(digits));
}

void conclude(const ExactParameters& a, const FoundZero<2>& found, int digits, NonstickingList& list) {
  const Box<2> box = refined(a, found.zero * Ball::pi(), digits);
  const WorkingPrecision scope(bits_for(digits) + 64);
  const TwoSlips f = two_slips_of(parameters_as<Ball>(a));
  const Ball beyond = box(0) - f.pi;
  if (box(0).is_negative() || beyond.is_positive()) {
    return;
  }
  const NonstickingOrbit orbit = describe_nonsticking(f, box, found.unique * f.pi);
  if (!box(0).is_positive() || !beyond.is_negative()) {
    list.unresolved.push_back({orbit.tau, box(1), "a motion one of whose phases may last no time at all"});
    return;
  }
  const bool known = std::any_of(list.orbits.begin(), list.orbits.end(), [&](const NonstickingOrbit& other) {
    return same_zero(other, orbit) || same_zero(orbit, other);
  });
  if (!known) {
    list.orbits.push_back(orbit);
  }
}

Condition condition(const char * id, const char * statement, const Ball& margin) {
  Condition result{id, statement, {}, margin, Ball(0), {}};
  const std::string value = to_string(margin, 10);
  result.verdict = margin.is_positive() ? Verdict::proved()
                   : margin.is_negative()
                       ? Verdict::refuted("the distance is " + value)
                       : Verdict::undecided("the distance is " + value + ", not separated from zero");
  return result;
}

}  // namespace

TwoSlips two_slips_of(const model::Parameters<Ball>& a) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(a);
  return {o, model::modal_rest<Ball>(o.modes, o.d0), Ball::pi()};
}

NonstickingOrbit describe_nonsticking(const TwoSlips& f, const Box<2>& box, const Box<2>& unique) {
  const Ball& omega = f.o.data.omega;
  NonstickingOrbit orbit;
  orbit.box = box;
  orbit.unique = unique;
  orbit.Theta = Ball(2) * f.pi / omega;
  orbit.phi = box(1) - box(0);
  if ((orbit.phi + f.pi).is_negative()) {
    orbit.phi += Ball(2) * f.pi;
  }
  orbit.motion = two_slips_motion<Ball>(f.o, f.c, f.pi, box(0), box(1));
  orbit.tau = orbit.motion.phases[0].duration;
  orbit.tau1 = orbit.motion.phases[1].duration;
  const model::Vector4<Ball>& Z0 = orbit.motion.phases[0].Z;
  orbit.x10 = Z0(0) + f.o.d0(0);
  orbit.x20 = Z0(1) + f.o.d0(1);
  orbit.xdot10 = Z0(2);
  orbit.ur_max = smaller(friction_at_start(orbit.motion, 0), -friction_at_start(orbit.motion, 1));
  return orbit;
}

NonstickingProof prove_nonsticking(const ExactParameters& a, const model::Vector2<double>& guess,
                                   int digits) {
  require_model_domain(a);
  require_no_resonance(a);
  ZeroProof<2> zero;
  {
    const WorkingPrecision scope(128);
    zero = prove_zero_near<2>(two_slips_of(parameters_as<Ball>(a)), Box<2>(Ball(guess(0)), Ball(guess(1))));
  }
  if (zero.verdict.truth != Truth::proved) {
    return {zero.verdict, {}};
  }
  const Box<2> box = refined(a, zero.box, digits);
  const WorkingPrecision scope(bits_for(digits) + 64);
  const TwoSlips f = two_slips_of(parameters_as<Ball>(a));
  if (!box(0).is_positive() || !(box(0) - f.pi).is_negative()) {
    return {Verdict::undecided("a motion one of whose phases may last no time at all"), {}};
  }
  return {zero.verdict, describe_nonsticking(f, box, zero.unique)};
}

NonstickingList list_nonsticking(const ExactParameters& a, int digits) {
  require_model_domain(a);
  require_no_resonance(a);
  NonstickingList list;
  if (a.p == 0 || a.omega == 1) {
    if (a.V == 0) {
      const Ball Theta = Ball(2) * Ball::pi() / Ball(a.omega);
      const Ball circle = Ball::hull(-Ball::pi(), Ball::pi());
      list.unresolved.push_back({Ball::hull(Ball(0), Theta), circle,
                                 "$q2 = 0$: the load does not act on $x2$ and its phase is free"});
    }
    return list;
  }
  SearchResult<2> result;
  {
    const WorkingPrecision scope(search_bits);
    const TwoSlips f = two_slips_of(parameters_as<Ball>(a));
    const Scaled g{f};
    result = search<2>({{0, mu_first}, {delta_last, mu_last}}, KrawczykContractor<2, Scaled>{g},
                       KrawczykDecider<2, Scaled>{g}, {0x1p-30, 200000});
    for (const UnresolvedBox<2>& open : result.unresolved) {
      if ((open.box(0) - Ball(1)).is_positive()) {
        continue;
      }
      list.unresolved.push_back(
          {Ball(2) * f.pi * open.box(0) / f.o.data.omega, open.box(1) * f.pi, open.reason});
    }
  }
  list.cells = result.cells;
  for (const FoundZero<2>& found : result.zeros) {
    conclude(a, found, digits, list);
  }
  std::sort(list.orbits.begin(), list.orbits.end(), [](const auto& x, const auto& y) {
    return std::pair(x.tau.approximate(), x.phi.approximate()) <
           std::pair(y.tau.approximate(), y.phi.approximate());
  });
  return list;
}

Condition room_for_friction(const Ball& ur_max, const Ball& us) {
  return condition("ur_max", "$min(r(0), -r(tau)) > us$", ur_max - us);
}

std::optional<Condition> condition_36(const model::Oscillator<Ball>& o, const Ball& delta, const Ball& phi,
                                      const Ball& ur) {
  const model::Parameters<Ball>& a = o.data;
  if (arb_is_zero(a.V.raw()) == 0 || !(Ball(2) * delta).overlaps(Ball::pi())) {
    return std::nullopt;
  }
  const Ball left = (a.chi * a.eta * (o.Q(1) - o.Q(0)) - a.p) * cos(phi) - a.eta * ur;
  return condition("36", "$chi eta (q2 - q1) cos(phi) - p cos(phi) - eta ur > 0$", left);
}

std::vector<Condition> nonsticking_conditions(const NonstickingOrbit& orbit, const std::optional<Ball>& ur) {
  std::vector<Condition> conditions = decide_conditions(Family::nonsticking, orbit.motion, ur);
  const model::Oscillator<Ball>& o = orbit.motion.oscillator;
  if (!ur) {
    conditions.push_back(room_for_friction(orbit.ur_max, o.data.us));
  } else if (const std::optional<Condition> load = condition_36(o, orbit.box(0), orbit.phi, *ur)) {
    conditions.push_back(*load);
  }
  return conditions;
}

}  // namespace stickslip::numeric::families
