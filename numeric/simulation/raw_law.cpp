// The equations of motion (2) with the friction law (4), integrated by Boost.Odeint: no H, Gamma, Q or any
// other closed form. The independent witness of everything that rests on those.
//
// No event inside a step is missed, and no touch of zero: a stretch of a step is passed only when the value
// of the event function in its middle, its rate and a bound of its second derivative, all read off (2), keep
// it from zero there; else the stretch is halved. This holds for the integrated motion, up to rounding.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_dense_output.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "core/domain.hpp"
#include "numeric/simulation/record.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;

namespace {

namespace odeint = boost::numeric::odeint;
using State = std::array<double, 4>;  // (x1, x2, x1', x2')

constexpr double tolerance = 1e-12;
constexpr double first_step = 1e-3;
constexpr long most_steps = 10000000;

double sign(double x) {
  return x < 0 ? -1 : 1;
}

// g >= value - |slope| s - bend s²/2 for all times within s of the one where value and slope are taken.
struct Gap {
  double value, slope, bend;
};

// Bounds of |r'|, |r''| and |r'''|.
struct Rates {
  double first, second, third;
};

// The law (2), (4), and the phase that selects u in it.
struct Law {
  Start start;
  PhaseKind phase = PhaseKind::slip;

  [[nodiscard]] double side() const { return phase == PhaseKind::slip ? 1 : -1; }
  [[nodiscard]] double load(double t) const {
    return start.data.p * std::cos(start.data.omega * t + start.phi);
  }
  [[nodiscard]] double load_rate(double t) const {
    return -start.data.omega * start.data.p * std::sin(start.data.omega * t + start.phi);
  }
  [[nodiscard]] double r(double t, const State& x) const {
    return start.data.chi * (x[1] - x[0]) - load(t) / start.data.eta;
  }
  [[nodiscard]] double r_rate(double t, const State& x) const {
    return start.data.chi * (x[3] - x[2]) - load_rate(t) / start.data.eta;
  }
  [[nodiscard]] double r_second(double t, const State& x) const {
    const model::Parameters<double>& a = start.data;
    State d;
    (*this)(x, d, t);
    return a.chi * (d[3] - d[2]) + a.omega * a.omega * load(t) / a.eta;
  }

  void operator()(const State& x, State& rate, double t) const {
    const model::Parameters<double>& a = start.data;
    const double acceleration =
        phase == PhaseKind::stick ? 0 : a.eta * side() * a.us + load(t) - a.chi * a.eta * (x[1] - x[0]);
    rate = {x[2], x[3], a.chi * x[1] - x[0], acceleration};
  }

  // In the norm of the largest component |X'| <= stiffness |X| + eta us + p.
  [[nodiscard]] double stiffness() const {
    return std::max(1 + start.data.chi, 2 * start.data.chi * start.data.eta);
  }

  // For all times within s of a state x.
  [[nodiscard]] Rates bounds(const State& x, double s) const {
    const model::Parameters<double>& a = start.data;
    const double force = a.eta * a.us + a.p;
    double size = 0;
    for (const double component : x) {
      size = std::max(size, std::abs(component));
    }
    size = (size + force * s) * std::exp(stiffness() * s);
    const double drive = 2 * a.chi * a.eta * size;
    const double load = a.p / a.eta;
    return {2 * a.chi * size + load * a.omega,
            a.chi * ((1 + a.chi) * size + force + drive) + load * a.omega * a.omega,
            a.chi * ((1 + a.chi) * size + a.p * a.omega + drive) + load * std::pow(a.omega, 3)};
  }

  // What is positive as long as the phase goes on: ±(V - x2') or ur - |r|.
  [[nodiscard]] Gap gap(double t, const State& x, double s) const {
    const Rates most = bounds(x, s);
    if (phase == PhaseKind::stick) {
      return {start.ur - std::abs(r(t, x)), r_rate(t, x), most.second};
    }
    const model::Parameters<double>& a = start.data;
    return {side() * (a.V - x[3]), a.eta * (side() * r(t, x) - a.us), a.eta * most.first};
  }

  // How long a gap that is zero at t, with the friction r there, certainly stays open; 0 when it does not
  // open.
  [[nodiscard]] double opens_for(double t, const State& x, double r) const {
    const double longest = 0.1 / stiffness();
    const Rates most = bounds(x, longest);
    if (phase == PhaseKind::stick) {
      return std::min(longest, positive_for(-sign(r) * r_rate(t, x), -sign(r) * r_second(t, x), most.third));
    }
    const model::Parameters<double>& a = start.data;
    return std::min(longest, positive_for(a.eta * (side() * r - a.us), a.eta * side() * r_rate(t, x),
                                          a.eta * most.second));
  }

  // Until when slope t + second t²/2 - third t³/6 > 0, for a bound third > 0.
  static double positive_for(double slope, double second, double third) {
    if (slope < 0 || (slope == 0 && second <= 0)) {
      return 0;
    }
    const double root = std::sqrt(second * second / 4 + 2 * third * slope / 3);
    return second > 0 ? (second / 2 + root) * 3 / third : 2 * slope / (root - second / 2);
  }
};

class Integrator {
 public:
  explicit Integrator(const Start& start)
      : law_{start, PhaseKind::slip},
        stepper_(odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<State>())) {
    const State x{start.X(0), start.X(1), start.X(2), start.X(3)};
    if (x[3] == start.data.V) {
      enter_at_belt_speed(0, x, law_.r(0, x));
    } else {
      law_.phase = x[3] < start.data.V ? PhaseKind::slip : PhaseKind::overshoot;
    }
    stepper_.initialize(x, 0, first_step);
  }

  Run run(double duration) {
    Run result;
    const auto law = [this](const State& x, State& rate, double t) { law_(x, rate, t); };
    for (long step = 0; step < most_steps; ++step) {
      const auto [begin, reached] = stepper_.do_step(law);
      const double end = std::min(reached, duration);
      if (!std::isfinite(law_.bounds(state(end), 0).third)) {
        throw InternalError(fmt::format("the raw law's motion is not finite at t = {}", end));
      }
      const double from = std::max(begin, open_until_);
      const auto event = from < end ? first_event(from, end) : std::nullopt;
      if (event) {
        result.transitions.push_back(pass_event(*event));
      } else if (end == duration) {
        const State x = state(end);
        result.end = {x[0], x[1], x[2], x[3]};
        return result;
      }
    }
    throw InternalError(fmt::format("the raw law needs more than {} steps", most_steps));
  }

 private:
  [[nodiscard]] State state(double t) const {
    State x;
    stepper_.calc_state(t, x);
    return x;
  }

  // The first time in [a, b] at which the gap is not certainly open, to some units in the last place.
  [[nodiscard]] std::optional<double> first_event(double a, double b) const {
    const double t = a + (b - a) / 2;
    const double s = std::max(t - a, b - t);
    const Gap g = law_.gap(t, state(t), s);
    if (g.value > std::abs(g.slope) * s + g.bend * s * s / 2) {
      return std::nullopt;
    }
    if (b - a <= 4 * std::numeric_limits<double>::epsilon() * std::max(1.0, b)) {
      return t;
    }
    const auto first = first_event(a, t);
    return first ? first : first_event(t, b);
  }

  // (4) at x2' = V, with the friction r there.
  void enter_at_belt_speed(double t, const State& x, double r) {
    double open = 0;
    if (std::abs(r) >= law_.start.ur) {
      law_.phase = r > 0 ? PhaseKind::slip : PhaseKind::overshoot;
      open = law_.opens_for(t, x, r);
    }
    if (open == 0) {
      law_.phase = PhaseKind::stick;
      open = std::abs(r) < law_.start.ur ? 0 : law_.opens_for(t, x, r);
      if (open == 0 && std::abs(r) >= law_.start.ur) {
        throw InternalError(fmt::format("at t = {} the friction law does not say what follows", t));
      }
    }
    // Half of it: the bounds meet zero at its end.
    open_until_ = t + open / 2;
  }

  Transition pass_event(double t) {
    const PhaseKind before = law_.phase;
    State x = state(t);
    x[3] = law_.start.data.V;
    const double r = law_.r(t, x);
    // A stick ends at |r| = ur; what is missing is rounding.
    enter_at_belt_speed(t, x,
                        before == PhaseKind::stick ? sign(r) * std::max(std::abs(r), law_.start.ur) : r);
    stepper_.initialize(x, t, first_step);
    return {t, before, law_.phase, r, {x[0], x[1], x[2], x[3]}};
  }

  Law law_;
  odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<State>>::type stepper_;
  double open_until_ = 0;  // until then the gap that was zero at the beginning of the phase is open
};

}  // namespace

Run follow_raw_law(const Start& start, double duration) {
  require(duration > 0 && std::isfinite(duration), "the duration", duration, "a finite number > 0");
  try {
    return Integrator(start).run(duration);
  } catch (const odeint::odeint_error& error) {
    throw InternalError(fmt::format("Boost.Odeint gave up: {}", error.what()));
  }
}

}  // namespace stickslip::numeric::simulation
