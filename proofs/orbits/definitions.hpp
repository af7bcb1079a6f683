// What theorems on orbits say of a phase: definitions of the kernel, in the data as parameters.
#pragma once

#include "numeric/motion/motion.hpp"
#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::orbits {

inline const kernel::Type state_type = kernel::real_matrix(4, 1);  // (x1, x2, x1', x2')
inline const kernel::Type motion_type = kernel::function_of_time(4, 1);

// (4): chi (x2 - x1) - (p/eta) cos(omega t + phi), of a state x and the time t.
[[nodiscard]] const kernel::Definition& friction();

// slips, overshoots: (2) during (a, b) with u = us or -us, and x2' < V or x2' > V there; sticks: (9), x2' = V
// and |r| < ur from a on until b. Each motion is continuous on [a, b].
[[nodiscard]] const kernel::Definition& phase_definition(numeric::motion::PhaseKind kind);

}  // namespace stickslip::proofs::orbits
