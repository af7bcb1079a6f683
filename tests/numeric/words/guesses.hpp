// Guesses for orbits of words: from orbits that are proved already, and from simulations.
#pragma once

#include "numeric/machines/machine_orbit.hpp"
#include "numeric/simulation/simulation.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::words {

using Guess = machines::MachineGuess;

// From a motion over so many periods, rounded to double; `again` takes it as many times.
[[nodiscard]] inline Guess guess_of(const motion::Motion& motion, long periods = 1, long again = 1) {
  const motion::MotionOf<double> m = motion::in_double(motion);
  const double period = motion::period(motion).approximate();
  Guess guess{{}, periods * again};
  for (long round = 0; round < again; ++round) {
    for (const motion::PhaseOf<double>& phase : m.phases) {
      const double t = m.phases.front().load / m.oscillator.data.omega + phase.start;
      const model::Vector4<double> X(phase.Z(0) + m.oscillator.d0(0), phase.Z(1) + m.oscillator.d0(1),
                                     phase.Z(2), m.oscillator.data.V);
      guess.events.push_back({t + static_cast<double>(round) * period, X, {phase.kind}});
    }
  }
  return guess;
}

// What the motion from X at t = 0 does in the n periods after so many others.
[[nodiscard]] inline Guess simulated(const WordQuestion& q, const model::Vector4<double>& X, long before,
                                     long n) {
  simulation::Simulation s(motion::parameters_as<double>(q.data), scalars::scalar<double>(q.ur), 0, X);
  const double lead = static_cast<double>(before) * s.period();
  s.advance(lead);
  std::vector<simulation::Transition> log;
  s.advance(static_cast<double>(n) * s.period(), &log);
  Guess guess{{}, n};
  for (const simulation::Transition& t : log) {
    guess.events.push_back({t.time - lead, t.X, {t.after}});
  }
  return guess;
}

}  // namespace stickslip::numeric::words
