// A friction oscillator exactly as it is given.
#pragma once

#include "core/rational.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/attractors/many_starts.hpp"
#include "numeric/machine.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

struct Machine {
  model::FrictionOscillator<Rational> oscillator;
  bool in_turns = false;  // omega stands for 2 pi times it: a frequency in Hz
};

// The paper's two masses, in SI units; the load's amplitude is its cosine. Assumes that the friction at rest
// is known.
[[nodiscard]] Machine machine_of(const MachineInSI& machine);

// At the working precision.
template <class S>
[[nodiscard]] model::FrictionOscillator<S> oscillator_as(const Machine& machine) {
  auto result = model::mapped<S>(machine.oscillator, [](const Rational& x) { return scalars::scalar<S>(x); });
  if (machine.in_turns) {
    result.omega = S(2) * scalars::pi<S>() * result.omega;
  }
  return result;
}

// sqrt(K_jj/m_j), 1 where that is 0: positions times it are compared with velocities.
[[nodiscard]] double scale_of(const model::FrictionOscillator<double>& oscillator);

// How far and how fast motions go: random starts lie within `half` of `middle` in each coordinate (x, x').
// The middle is the rest position under the constant loads and the friction at the belt's velocity, at rest
// but for the mass that rubs; with Omega² = K_jj/m_j and s the largest of |V|, 3 u/(m_j Omega) and the loads'
// amplitudes over their masses and Omega: 2 s/Omega for x, 1.5 s for x', x_j' about V - s.
[[nodiscard]] attractors::StartBoxOf<Eigen::VectorXd> start_box(
    const model::FrictionOscillator<double>& oscillator);

// The law with pieces near a smooth one: they meet it at so many points, with errors in between of one size.
[[nodiscard]] model::FrictionLaw<Rational> smooth_law(const Rational& at_rest,
                                                      const model::SmoothFriction<Rational>& friction);
inline constexpr int smooth_pieces = 32;

// Throws DomainError unless there is a mass, all are > 0, C and K are symmetric and as large, the rubbing
// mass is one of them, omega > 0 where a load varies, and the friction of each side is a law: > 0 at rest,
// pieces that begin at 0, each after the one before, together continuous and >= 0 where they begin, and at
// most the friction at rest at first; of a smooth one all forces >= 0, the velocity > 0,
// and the force at 0 that of its pieces.
void require_machine(const Machine& machine);

}  // namespace stickslip::numeric::machines
