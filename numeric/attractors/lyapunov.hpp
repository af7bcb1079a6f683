// The largest Lyapunov exponent of a simulated motion: a check, no proof.
#pragma once

#include "numeric/attractors/kind.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::attractors {

// Per period of the load: a small deviation grows by exp(value) in each, in the mean.
struct Exponent {
  double value = 0;
  double error = 0;  // its standard error, from blocks
  // What a finite time may leave of an exponent that is zero: on a torus deviations grow in proportion to
  // time.
  double least = 0;

  [[nodiscard]] bool is_positive() const { return value > 3 * error && value > least; }
  [[nodiscard]] bool is_negative() const { return -value > 3 * error && -value > least; }
  // Zero as far as a long time tells: what it leaves is positive.
  [[nodiscard]] bool is_zero() const { return -value < least / 3 && value < least && least < 0.0015; }
};

// From the motion and a neighbour that is brought back to a small distance after each of so many periods,
// after a lead of a fifth as many. The simulation, of an oscillator with a load, is to be at a time when its
// phase is 0. One that is interrupted says nothing.
template <int N, int L>
[[nodiscard]] Exponent largest_exponent(simulation::SimulationOf<N, L> simulation, long periods);

// Fewer periods say nothing.
inline constexpr long fewest_periods_of_exponent = 100;
// What an exponent says of a motion that does not return: irregular, quasi-periodic, or nothing, unsettled.
[[nodiscard]] Kind kind_by(const Exponent& exponent);

}  // namespace stickslip::numeric::attractors
