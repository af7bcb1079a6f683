// What the motion of a machine settles on, followed in doubles: it proposes, and proves nothing.
#pragma once

#include <memory>

#include "numeric/attractors/follower.hpp"
#include "numeric/machines/machine.hpp"

namespace stickslip::numeric::machines {

struct Settled {
  attractors::Kind kind = attractors::Kind::unsettled;  // all but one that grows
  MachineGuess guess;                                   // of a periodic one: its events
  Eigen::VectorXd state;                                // (x, x') at the end, with a load at theta = 0
};

// The motion from X at theta = 0. It has settled as periodic when it has come back, within some 1e-9 of its
// size, to a state that it was in: after n periods of the load, or, without one, at an event of the same
// kind; as slides or stuck when that happens without an event on the way, or no event comes for long.
// Within so many periods of the load, else, irregular or quasi-periodic by the largest Lyapunov exponent over
// a quarter as many more, if that tells (attractors/follower.hpp: a check); unsettled without a load within
// so many events. Throws as require_machine does, and DomainError for a state of the wrong size.
[[nodiscard]] Settled settle(const Machine& machine, const Eigen::VectorXd& X, long most_periods = 20000);

// They follow the motions of a machine from there. Throws likewise.
using Followers = std::vector<std::unique_ptr<attractors::AnyFollower>>;
[[nodiscard]] Followers followers_of(const Machine& machine, const std::vector<Eigen::VectorXd>& starts);

// What is seen, begun at the first rotation of its word, and once if it goes round a shorter motion several
// times.
[[nodiscard]] attractors::Return tidied(const Machine& machine, const attractors::Return& seen);

// The motion from X at theta = 0 over the next n periods of the load, as it is, closed or not. Throws
// likewise, and UsageError without a load.
[[nodiscard]] MachineGuess over_periods(const Machine& machine, const Eigen::VectorXd& X, long n);

}  // namespace stickslip::numeric::machines
