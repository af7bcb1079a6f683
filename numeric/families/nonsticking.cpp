#include "numeric/families/nonsticking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain.hpp"
#include "core/error.hpp"
#include "numeric/families/through_phases/isolate.hpp"
#include "numeric/motion/infimum.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace zeros;

namespace {

// The search looks at x = (delta/pi, mu/pi). It covers [0, 1] × an interval of length 2 with a little to
// spare: then the halvings do not meet delta = pi/2 and sin(mu) = 0, where zeros with a symmetry lie and
// would be cut in two.
constexpr double delta_last = 1.0371;
constexpr double mu_first = -0.9137;
constexpr double mu_last = 1.0868;

struct Scaled {
  TwoSlips f;

  template <class T>
  [[nodiscard]] model::Vector2<T> operator()(const model::Vector2<T>& x) const {
    const T pi(f.pi);
    return f(model::Vector2<T>(T(pi * x(0)), T(pi * x(1))));
  }
};

// The motion of half a period and its mirror image, for V = 0: the load's phase is the unknown. Regular where
// omega_j is an even multiple of omega.
struct HalfPeriodClosing {
  static constexpr bool takes_phi = false, takes_ur = false;

  template <class T>
  [[nodiscard]] static model::HalfPeriod<T> half(const model::Oscillator<T>& o) {
    return model::half_period<T>(o.data.chi, o.modes, o.d0, o.data.omega, T(Ball::pi()));
  }
  // Nothing is known of data of which some have V ≠ 0.
  template <class T>
  [[nodiscard]] static bool stands_still(const T& V) {
    if constexpr (std::is_same_v<T, Ball>) {
      return arb_is_zero(V.raw()) != 0;
    } else {
      return arb_is_zero(V.value.raw()) != 0;
    }
  }
  template <class T>
  [[nodiscard]] VectorOf<T> closing(const VectorOf<T>& x, const VectorOf<T>& p) const {
    const model::Oscillator<T> o = oscillator_of<T>(p);
    VectorOf<T> f(1);
    f << half(o).friction_speed + o.Q(1) * o.data.omega * T(sin(x(0)));
    if (!stands_still(o.data.V)) {
      f(0) = f(0) / T(0);
    }
    return f;
  }
  template <class T>
  [[nodiscard]] MotionOf<T> motion(const VectorOf<T>& x, const VectorOf<T>& p) const {
    const model::Oscillator<T> o = oscillator_of<T>(p);
    const T pi(Ball::pi());
    const T tau = pi / o.data.omega;
    const model::Vector4<T> Z0 =
        model::half_period_start<T>(half(o), o.Q, o.d0, o.data.omega, T(cos(x(0))), T(sin(x(0))));
    model::Vector4<T> ZB = -Z0;
    ZB(0) -= T(2) * o.d0(0);
    ZB(1) -= T(2) * o.d0(1);
    return {o, {{PhaseKind::slip, T(0), tau, x(0), Z0}, {PhaseKind::overshoot, tau, tau, T(x(0) + pi), ZB}}};
  }
  [[nodiscard]] Vector unknowns(const Motion& motion) const {
    Vector x(1);
    x << motion.phases.front().load;
    return x;
  }
};

// V = 0, omega_j an even multiple of omega: the two motions of half a period, if there are any.
Found symmetric_ones(const ExactParameters& a) {
  const WorkingPrecision scope(guess_bits);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const Ball speed = HalfPeriodClosing::half(o).friction_speed / (-o.Q(1) * o.data.omega);
  const Ball tau = Ball::pi() / o.data.omega;
  Found result;
  result.remarks.push_back(Remark::closes_without_stick);
  if ((Ball(1) - abs(speed)).is_negative()) {
    return result;
  }
  if (!(Ball(1) - abs(speed)).is_positive()) {
    result.unresolved.push_back({{{"tau", tau}}, "two zeros that cannot be told from a multiple one"});
    return result;
  }
  Ball phi;
  arb_asin(phi.raw(), speed.raw(), guess_bits);
  for (const int side : {1, -1}) {
    if (side == -1) {
      phi = (speed.is_negative() ? -Ball::pi() : Ball::pi()) - phi;
    }
    const Closing equations = HalfPeriodClosing{};
    Vector x(1);
    x << phi;
    const auto is_same = [side](const Motion& motion) {
      return (Ball(side) * cos(motion.phases.front().load)).is_positive();
    };
    result.candidates.push_back(
        {{equations.motion<Ball>(x, equations.parameters({o.data})), {{"tau", tau}, {"phi", phi}}, is_same},
         equations,
         0,
         0});
  }
  return result;
}

// omega_j = k omega: where an orbit may be, as nonsticking.hpp says.
Found at_resonance(const ExactParameters& a, const Resonances& k) {
  require(k.first != 1 && k.second != 1, "omega", a.omega, "not a natural frequency: omega ≠ omega1, omega2");
  Found result;
  if (a.V == 0) {
    if (k.first % 2 == 0 && k.second % 2 == 0) {
      return symmetric_ones(a);
    }
    result.remarks.push_back(Remark::odd_resonance);
    return result;
  }
  const long most = std::max(k.first, k.second);
  for (long l = 1; l < most; ++l) {
    if (k.first * l % most == 0 && k.second * l % most == 0) {
      const Ball tau = Ball(2 * l) * Ball::pi() / (Ball(most) * Ball(a.omega));
      result.unresolved.push_back(
          {{{"tau", tau}},
           fmt::format(
               "${} omega$ is a natural frequency: orbits are not alone, the free oscillation of that "
               "frequency can be added to one as long as the conditions hold",
               k.first != 0 ? k.first : k.second)});
    }
  }
  return result;
}

// Whether the zero lies in the box, modulo 2 pi in mu.
bool lies_in(const Box<2>& box, Box<2> zero) {
  zero(1) -= Ball(2);
  for (int turn = -1; turn <= 1; ++turn) {
    if (contains<2>(box, zero)) {
      return true;
    }
    zero(1) += Ball(2);
  }
  return false;
}

// (tau, phi) at (delta/pi, mu/pi), phi in [-pi, pi] or a little outside.
std::vector<NamedBall> tau_and_phi(const TwoSlips& f, const Box<2>& x) {
  Ball phi = (x(1) - x(0)) * f.pi;
  if ((phi + f.pi).is_negative()) {
    phi += Ball(2) * f.pi;
  }
  return {{"tau", Ball(2) * f.pi * x(0) / f.o.data.omega}, {"phi", phi}};
}

// For the search.
struct Searched {
  Scaled g;

  [[nodiscard]] std::optional<Box<2>> contract(const Box<2>& X) const {
    return contract_by_krawczyk<2>(g, X);
  }
  [[nodiscard]] ZeroProof<2> decide(const Box<2>& X) const { return decide_by_krawczyk<2>(g, X); }
  [[nodiscard]] std::optional<Unresolved> left_open(const UnresolvedBox<2>& open) const {
    if ((open.box(0) - Ball(1)).is_positive()) {
      return std::nullopt;
    }
    const Ball tau = Ball(2) * g.f.pi * open.box(0) / g.f.o.data.omega;
    return Unresolved{{{"tau", tau}, {"phi", open.box(1) * g.f.pi - g.f.o.data.omega * tau / Ball(2)}},
                      open.reason};
  }
};

Scaled scaled(const ExactParameters& a) {
  return {two_slips_of(parameters_as<Ball>(a))};
}

// The zero, refined, as a motion to be proved, if it is inside.
Concluded<Candidate> conclude(const ExactParameters& a, const ZeroProof<2>& found) {
  const Box<2> x = refine<2>([&] { return scaled(a); }, found.box, guess_bits);
  const TwoSlips f = scaled(a).f;
  const std::vector<NamedBall> where = tau_and_phi(f, x);
  return concluded<Candidate>(place(x(0)), where, [&] {
    const Closing equations = NonstickingClosing{};
    const Ball delta = f.pi * x(0);
    Vector delta_mu(2);
    delta_mu << delta, where[1].value + delta;
    const auto is_same = [unique = found.unique](const Motion& motion) {
      const Phase& slip = motion.phases[0];
      const Ball share = slip.duration / period(motion);
      return lies_in(unique, {share, slip.load / Ball::pi() + share});
    };
    return Candidate{{equations.motion<Ball>(delta_mu, equations.parameters({f.o.data})), where, is_same},
                     equations,
                     0,
                     1};
  });
}

// Without those that are there again modulo 2 pi; by tau, then phi.
void sort_out(std::vector<Candidate>& all) {
  std::vector<Candidate> different;
  for (const Candidate& one : all) {
    if (std::ranges::none_of(different, [&](const Candidate& other) {
          return other.is_same(one.guess) || one.is_same(other.guess);
        })) {
      different.push_back(one);
    }
  }
  const auto key = [](const Candidate& c) {
    return std::pair(c.where[0].value.approximate(), c.where[1].value.approximate());
  };
  std::ranges::sort(different, {}, key);
  all = std::move(different);
}

Found search_nonsticking(const Given<Rational>& given) {
  const ExactParameters& a = given.data;
  require_model_domain(a);
  Found result;
  const bool acts = a.p != 0 && a.omega != 1;
  if (!acts && a.V == 0) {
    result.remarks.push_back(Remark::nothing_drives);
    return result;
  }
  if (const Resonances k = resonances(a); k.first != 0 || k.second != 0) {
    return at_resonance(a, k);
  }
  if (!acts) {
    return result;
  }
  result = isolate<Candidate, 2>(
      {{0, mu_first}, {delta_last, mu_last}}, {0x1p-30, 200000}, [&] { return Searched{scaled(a)}; },
      [&](const ZeroProof<2>& zero) { return conclude(a, zero); });
  sort_out(result.candidates);
  return result;
}

// The two equations, without their poles, at (delta/pi, mu/pi), and (delta, mu).
struct OverStrip {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& first, const T& second) const {
    const model::Parameters<T>& a = given.data;
    const model::Modes<T> m = model::modes<T>(a.chi, a.eta);
    const T pi(scalars::pi<S>());
    const T delta = pi * first;
    const T mu = pi * second;
    const model::Vector2<T> c = model::modal_rest<T>(m, model::d0<T>(a.chi, a.us));
    const model::Vector2<T> f = model::two_slips_without_poles<T>(a, m, c, pi, delta, mu);
    return {{f(0), f(1)}, {scalars::ends(delta.over), scalars::ends(mu.over)}};
  }
};

std::vector<Strip> nonsticking_strips(const StripQuestion& q) {
  return {strip_of(q, 0, 1, {{0, mu_first, 0}, {1, mu_last, 1}}, OverStrip{})};
}

Condition condition(const char * id, const char * statement, const Ball& margin) {
  Condition result{id, statement, {}, {}, Ball(0), {}};
  judge(result, margin, true, "the distance");
  return result;
}

// Without u_r: that some u_r > u_s satisfies (25) and (26). With it (36), which is about the half-period
// orbit: for V = 0 where tau may be Theta/2.
std::vector<Condition> further(const Motion& motion, const Ball& ur_max, const std::optional<Ball>& ur) {
  const model::Oscillator<Ball>& o = motion.oscillator;
  const model::Parameters<Ball>& a = o.data;
  const Phase& slip = motion.phases[0];
  if (!ur) {
    return {condition("ur_max", "$min(r(0), -r(tau)) > us$", ur_max - a.us)};
  }
  if (arb_is_zero(a.V.raw()) == 0 || !(a.omega * slip.duration).overlaps(Ball::pi())) {
    return {};
  }
  return {condition("36", "$chi eta (q2 - q1) cos(phi) - p cos(phi) - eta ur > 0$",
                    (a.chi * a.eta * (o.Q(1) - o.Q(0)) - a.p) * cos(slip.load) - a.eta * *ur)};
}

}  // namespace

TwoSlips two_slips_of(const model::Parameters<Ball>& a) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(a);
  return {o, model::modal_rest<Ball>(o.modes, o.d0), Ball::pi()};
}

Vector NonstickingClosing::unknowns(const Motion& motion) const {
  if (motion.phases.size() != 2) {
    throw InternalError("a motion of other phases than a slip and an overshoot");
  }
  const Phase& slip = motion.phases[0];
  const Ball delta = motion.oscillator.data.omega * slip.duration / Ball(2);
  Vector x(2);
  x << delta, slip.load + delta;
  return x;
}

const Family& nonsticking() {
  static const Family family{
      .name = "nonsticking",
      .title = "Non-sticking orbits: slip on $(0, tau)$, overshoot on $(tau, Theta)$",
      .phases = {PhaseKind::slip, PhaseKind::overshoot},
      .durations = {"tau", "tau1"},
      .requirements =
          joined({sound_data({"tau", "tau1"}),
                  {{"25", "$z2'(0) = V$, $chi eta (z20 - z10) > p cos(phi) + eta (ur - us)$",
                    Quantity::beyond_ur, 0},
                   {"26", "$z2'(tau) = V$, $chi eta (z2B - z1B) < p cos(omega tau + phi) - eta (ur + us)$",
                    Quantity::beyond_minus_ur, 1},
                   slips(0, "$z2' < V$ for $0 < t < tau$"),
                   overshoots(1, "$z2' > V$ for $tau < t < Theta$")}}),
      .why_no_phi = "phi is not given for non-sticking orbits: it is a result",
      .why_no_ur = "",
      .why_datum = "",
      .searched = [](const OrbitQuestion&) { return std::string("$0 <= tau <= Theta$, every $phi$"); },
      .search = search_nonsticking,
      .strips = nonsticking_strips,
      .further = further,
      .judges = &atlas::nonsticking_judges,
      // (36) is (25) of an orbit whose slip lasts half a period at V = 0: there x(0) = Q cos(phi), for the
      // motion that the friction excites alone is odd about t = 0.
      .at_rest = {{"36", "", Quantity::beyond_ur, 0}},
      .first_singular = 1};
  return family;
}

namespace {

// -x2' on the slip for another C: +1 if it is positive between the ends, -1 if it is negative somewhere, else
// 0.
int moves_down(const model::Wave<Ball>& zdot2, const Ball& tau, const Ball& C) {
  model::Wave<Ball> g = affine<Ball>(Ball(-1), zdot2, Ball(0));
  g.harmonics[2].b = C;
  const Ball least = weighted_infimum(g, tau, {.start = true, .end = true}).value;
  return least.is_positive() ? 1 : least.is_negative() ? -1 : 0;
}

Ball larger(const Ball& a, const Ball& b) {
  const Ball gap = a - b;
  return gap.is_positive() ? a : gap.is_negative() ? b : Ball::hull(a, b);
}

}  // namespace

LeastLoad least_load(const Motion& motion, const Ball& ur, int digits) {
  if (motion.phases.empty() || motion.phases.front().kind != PhaseKind::slip) {
    throw InternalError("a motion without a slip to begin with has no least load");
  }
  const model::Oscillator<Ball>& o = motion.oscillator;
  const Ball& tau = motion.phases.front().duration;
  const model::Wave<Ball> zdot2 = waves(motion, 0).zdot2;
  const Ball B = zdot2.harmonics[2].a;
  const double C = -zdot2.harmonics[2].b.approximate();
  Rational below(-1), above(1);
  const auto side = [&](const Rational& at) { return moves_down(zdot2, tau, Ball(at)); };
  for (int i = 0; i < 64 && side(above) != 1; ++i) {
    above *= 2;
  }
  for (int i = 0; i < 64 && side(below) != -1; ++i) {
    below *= 2;
  }
  if (side(above) != 1 || side(below) != -1) {
    throw InternalError("no load keeps the slip going, or every load does");
  }
  Rational width(std::max(1.0, std::abs(C)));
  for (int i = 0; i < digits; ++i) {
    width /= 10;
  }
  while (above - below > width) {
    const Rational middle = (above + below) / 2;
    const int decided = side(middle);
    if (decided == 0) {
      break;
    }
    (decided == 1 ? above : below) = middle;
  }
  LeastLoad result;
  result.speed_push = Ball::hull(Ball(below), Ball(above));
  result.friction_push = o.data.eta * ur / o.data.omega;
  const Ball push = larger(result.speed_push, result.friction_push);
  result.p = abs(o.data.p / (o.Q(1) * o.data.omega)) * sqrt(B * B + push * push);
  return result;
}

}  // namespace stickslip::numeric::families
