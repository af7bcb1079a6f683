// The largest Lyapunov exponent of a simulated motion: a check, no proof.
#pragma once

#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::attractors {

// Per period of the load: a small deviation grows by exp(value) in each, in the mean.
struct Exponent {
  double value = 0;
  double error = 0;  // its standard error, from blocks

  // Three standard errors from zero, and farther than what a finite time leaves of an exponent that is zero.
  [[nodiscard]] bool is_positive() const { return value > 3 * error && value > least; }
  [[nodiscard]] bool is_negative() const { return -value > 3 * error && -value > least; }
  static constexpr double least = 0.001;
};

// From the motion and a neighbour that is brought back to a small distance after each period. The simulation
// is to be at a time when the load's phase is 0.
[[nodiscard]] Exponent largest_exponent(simulation::Simulation simulation);

}  // namespace stickslip::numeric::attractors
