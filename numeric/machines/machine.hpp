// A friction oscillator exactly as it is given.
#pragma once

#include "core/rational.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

struct Machine {
  model::FrictionOscillator<Rational> oscillator;
  bool in_turns = false;  // omega stands for 2 pi times it: a frequency in Hz
};

// At the working precision.
template <class S>
[[nodiscard]] model::FrictionOscillator<S> oscillator_as(const Machine& machine) {
  auto result = model::mapped<S>(machine.oscillator, [](const Rational& x) { return scalars::scalar<S>(x); });
  if (machine.in_turns) {
    result.omega = S(2) * scalars::pi<S>() * result.omega;
  }
  return result;
}

// Throws DomainError unless there is a mass, all are > 0, C and K are symmetric and as large, the rubbing
// mass is one of them, omega > 0 where a load varies, and the friction of each side is a law: > 0 at rest,
// pieces that begin at 0, each after the one before, together continuous and >= 0 where they begin, and below
// the friction at rest at first: at most it, where motions are only followed (`strict` false).
void require_machine(const Machine& machine, bool strict);

}  // namespace stickslip::numeric::machines
