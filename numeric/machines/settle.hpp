// What the motion of a machine settles on, followed in doubles: it proposes, and proves nothing.
#pragma once

#include "numeric/attractors/kind.hpp"
#include "numeric/machines/machine_orbit.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::machines {

struct Settled {
  attractors::Kind kind = attractors::Kind::unsettled;  // periodic, slides, stuck or unsettled
  MachineGuess guess;                                   // of a periodic one: its events
  Eigen::VectorXd state;                                // (x, x') at the end, with a load at theta = 0
};

// The motion from X at theta = 0. It has settled as periodic when it has come back, within some 1e-9 of its
// size, to a state that it was in: after n periods of the load, or, without one, at an event of the same
// kind; as slides or stuck when that happens without an event on the way, or no event comes for long.
// Unsettled within so many periods or, without a load, events. Throws as require_machine does, and
// DomainError for a state of the wrong size.
[[nodiscard]] Settled settle(const Machine& machine, const Eigen::VectorXd& X, long most_periods = 20000);

}  // namespace stickslip::numeric::machines
