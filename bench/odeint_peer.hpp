// The same law by Boost.Odeint: dopri5 with dense output, events by the signs at the ends of the steps and
// bisection in the dense output. A peer for speed; it misses what happens inside a step.
#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "numeric/simulation/run.hpp"

namespace stickslip::bench {

class OdeintPeer {
 public:
  using State = std::array<double, 4>;

  OdeintPeer(const numeric::simulation::Start& start, double tolerance)
      : start_(start), tolerance_(tolerance) {}

  // The number of events in the duration; the state at its end is end().
  int run(double duration) {
    namespace odeint = boost::numeric::odeint;
    auto stepper = odeint::make_dense_output(tolerance_, tolerance_, odeint::runge_kutta_dopri5<State>());
    State x{start_.X(0), start_.X(1), start_.X(2), start_.X(3)};
    phase_ = x[3] < start_.data.V ? numeric::motion::PhaseKind::slip : numeric::motion::PhaseKind::overshoot;
    int events = 0;
    stepper.initialize(x, 0, first_step);
    const auto law = [this](const State& y, State& d, double t) { rate(y, d, t); };
    while (true) {
      const auto [t0, t1] = stepper.do_step(law);
      const double end = std::min(t1, duration);
      stepper.calc_state(end, x);
      if (distance(x, end) < 0) {
        const double t = event_between(stepper, t0, end);
        stepper.calc_state(t, x);
        pass(x, t);
        ++events;
        stepper.initialize(x, t, first_step);
      } else if (end == duration) {
        end_ = x;
        return events;
      }
    }
  }

  [[nodiscard]] const State& end() const { return end_; }

 private:
  static constexpr double first_step = 1e-3;

  [[nodiscard]] double load(double t) const {
    return start_.data.p * std::cos(start_.data.omega * t + start_.phi);
  }
  [[nodiscard]] double r(const State& x, double t) const {
    return start_.data.chi * (x[1] - x[0]) - load(t) / start_.data.eta;
  }
  void rate(const State& x, State& d, double t) const {
    const model::Parameters<double>& a = start_.data;
    const double q = load(t);
    const double at_rest = a.chi * (x[1] - x[0]) - q / a.eta;
    const double u = phase_ == numeric::motion::PhaseKind::stick
                         ? at_rest
                         : (phase_ == numeric::motion::PhaseKind::slip ? a.us : -a.us);
    d = {x[2], x[3], a.chi * x[1] - x[0], a.eta * (u - at_rest)};
  }
  [[nodiscard]] double distance(const State& x, double t) const {
    switch (phase_) {
      case numeric::motion::PhaseKind::slip:
        return start_.data.V - x[3];
      case numeric::motion::PhaseKind::overshoot:
        return x[3] - start_.data.V;
      case numeric::motion::PhaseKind::stick:
        return start_.ur - std::abs(r(x, t));
    }
    return 0;
  }
  template <class Stepper>
  [[nodiscard]] double event_between(const Stepper& stepper, double inside, double outside) const {
    State x;
    while (outside - inside > 1e-13) {
      const double middle = (inside + outside) / 2;
      stepper.calc_state(middle, x);
      (distance(x, middle) < 0 ? outside : inside) = middle;
    }
    return inside;
  }
  void pass(State& x, double t) {
    const double at_rest = r(x, t);
    const bool sticks = phase_ != numeric::motion::PhaseKind::stick && std::abs(at_rest) < start_.ur;
    x[3] = start_.data.V;
    phase_ = sticks
                 ? numeric::motion::PhaseKind::stick
                 : (at_rest > 0 ? numeric::motion::PhaseKind::slip : numeric::motion::PhaseKind::overshoot);
  }

  numeric::simulation::Start start_;
  double tolerance_;
  numeric::motion::PhaseKind phase_ = numeric::motion::PhaseKind::slip;
  State end_{};
};

}  // namespace stickslip::bench
