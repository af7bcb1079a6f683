#include "numeric/simulation/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace stickslip::numeric::simulation {

using namespace motion;

namespace {

double ur_of(const Orbit& orbit) {
  for (const NamedBall& value : orbit.values) {
    if (value.name == "ur") {
      return value.value.approximate();
    }
    if (value.name == "ur_max") {
      return (value.value.approximate() + orbit.motion.oscillator.data.us.approximate()) / 2;
    }
  }
  throw InternalError("an orbit without friction at rest");
}

Ball half_of_first(const Motion& motion) {
  return motion.phases.front().duration / Ball(2);
}

// When the phase after the first that begins k-th begins, counted from the middle of the first.
Ball expected_time(const Motion& motion, std::size_t k) {
  const Phase& phase = motion.phases[k % motion.phases.size()];
  const Ball start = k == motion.phases.size() ? period(motion) : phase.start;
  return start - half_of_first(motion);
}

std::string word(const std::vector<Transition>& transitions) {
  std::string text;
  for (const Transition& t : transitions) {
    text += fmt::format("{}{} at {:.6g}", text.empty() ? "" : ", ", to_string(t.after), t.time);
  }
  return text.empty() ? "no event" : text;
}

}  // namespace

Run follow(const Start& start, double duration) {
  Simulation simulation(start.data, start.ur, start.phi, start.X);
  Run run;
  simulation.advance(duration, &run.transitions);
  run.end = simulation.state();
  return run;
}

Start start_of(const Orbit& orbit) {
  const Motion& motion = orbit.motion;
  const Ball half = half_of_first(motion);
  const model::Vector4<Ball> Z = state(motion, 0, half);
  const model::Vector2<Ball>& d0 = motion.oscillator.d0;
  const Ball phi = motion.phases.front().load + motion.oscillator.data.omega * half;
  return {in_double(motion).oscillator.data,
          ur_of(orbit),
          phi.approximate(),
          {Ball(Z(0) + d0(0)).approximate(), Ball(Z(1) + d0(1)).approximate(), Z(2).approximate(),
           Z(3).approximate()}};
}

Agreement agreement(const Orbit& orbit, const Follow& way) {
  const Motion& motion = orbit.motion;
  const Start start = start_of(orbit);
  const Run run = way(start, period(motion).approximate());
  Agreement result;
  const std::size_t count = motion.phases.size();
  bool same = run.transitions.size() == count;
  for (std::size_t k = 1; same && k <= count; ++k) {
    const Transition& t = run.transitions[k - 1];
    same = t.before == motion.phases[k - 1].kind && t.after == motion.phases[k % count].kind;
    const Ball error = abs(Ball(t.time) - expected_time(motion, k)).upper();
    result.time_error = std::max(result.time_error, error.approximate());
  }
  if (!same) {
    result.difference = "the events met are: " + word(run.transitions);
  }
  result.closure = (run.end - start.X).lpNorm<Eigen::Infinity>();
  return result;
}

}  // namespace stickslip::numeric::simulation
