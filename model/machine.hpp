// A machine with its units, and (3): what it is to equations (2) and (4).
#pragma once

#include "model/parameters.hpp"

namespace stickslip::model {

// In any coherent units, such as those of the SI.
template <class S>
struct Machine {
  S m1, m2;             // masses > 0
  S k1, k2;             // stiffnesses > 0, k1 to the wall, k2 between the masses
  S friction_sliding;   // force > 0
  S belt_velocity;      // v0
  S load_amplitude;     // force
  S angular_frequency;  // of the load, > 0
};

template <class S>
[[nodiscard]] S Omega_squared(const Machine<S>& m) {
  return (m.k1 + m.k2) / m.m1;
}

// The length that stands for a force, u = F/(k1 + k2).
template <class S>
[[nodiscard]] S length_of(const Machine<S>& m, const S& force) {
  return force / (m.k1 + m.k2);
}

// (3), with Omega > 0 the root of Omega_squared. Lengths stay what they are: us, V and p are in the unit that
// x has.
template <class S>
[[nodiscard]] Parameters<S> dimensionless(const Machine<S>& m, const S& Omega) {
  const S eta = m.m1 / m.m2;
  return {m.k2 / (m.k1 + m.k2),
          eta,
          length_of<S>(m, m.friction_sliding),
          m.belt_velocity / Omega,
          m.angular_frequency / Omega,
          eta * length_of<S>(m, m.load_amplitude)};
}

}  // namespace stickslip::model
