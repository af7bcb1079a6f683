// The same law by Boost.Odeint: dopri5 with dense output, events by the signs at the ends of the steps and
// bisection in the dense output. A peer for speed; it misses what happens inside a step.
#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>

#include "bench/raw_law.hpp"

namespace stickslip::bench {

// Follows the motion from x, of so many numbers, to where it is after the duration; returns the number of
// events.
template <std::size_t states>
int follow_by_odeint(RawLaw& law, std::array<double, states>& x, double duration, double tolerance) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, states>;
  constexpr double first_step = 1e-3;
  auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<State>());
  const auto rate = [&law](const State& y, State& d, double t) { law.rate(t, y.data(), d.data()); };
  law.begin(x.data());
  int events = 0;
  stepper.initialize(x, 0, first_step);
  while (true) {
    const auto [t0, t1] = stepper.do_step(rate);
    const double end = std::min(t1, duration);
    stepper.calc_state(end, x);
    if (law.distance(end, x.data()) >= 0) {
      if (end == duration) {
        return events;
      }
      continue;
    }
    double inside = t0, outside = end;
    while (outside - inside > 1e-13) {
      const double middle = (inside + outside) / 2;
      stepper.calc_state(middle, x);
      (law.distance(middle, x.data()) < 0 ? outside : inside) = middle;
    }
    stepper.calc_state(inside, x);
    law.pass(inside, x.data());
    ++events;
    stepper.initialize(x, inside, first_step);
  }
}

}  // namespace stickslip::bench
