// Guesses for orbits of words: from orbits that are proved already, and from simulations.
#pragma once

#include "numeric/machines/orbits/machine_orbit.hpp"
#include "numeric/simulation/simulation.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::words {

using machines::MachineGuess;

// From a motion over so many periods, rounded to double; `again` takes it as many times.
[[nodiscard]] inline MachineGuess guess_of(const motion::Motion& motion, long periods = 1, long again = 1) {
  const MachineGuess once = machines::guess_of(motion, periods);
  MachineGuess guess{{}, periods * again};
  for (long round = 0; round < again; ++round) {
    for (MachineGuess::Event event : once.events) {
      event.t += static_cast<double>(round) * once.duration;
      guess.events.push_back(event);
    }
  }
  return guess;
}

// What the motion from X at t = 0 does in the n periods after so many others.
[[nodiscard]] inline MachineGuess simulated(const WordQuestion& q, const model::Vector4<double>& X,
                                            long before, long n) {
  simulation::Simulation s(motion::parameters_as<double>(q.data), scalars::scalar<double>(q.ur), 0, X);
  const double lead = static_cast<double>(before) * s.period();
  s.advance(lead);
  std::vector<simulation::Transition> log;
  s.advance(static_cast<double>(n) * s.period(), &log);
  MachineGuess guess{{}, n};
  for (const simulation::Transition& t : log) {
    guess.events.push_back({t.time - lead, t.X, {t.after}});
  }
  return guess;
}

}  // namespace stickslip::numeric::words
