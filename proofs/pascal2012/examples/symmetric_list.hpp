// All solutions of the reduced equations of symmetric orbits at the data of an example, as theorems.
#pragma once

#include "proofs/pascal2012/examples/example_orbit.hpp"

namespace stickslip::proofs::pascal2012 {

// In variables tau, C and sigma, 1 or -1 for the two phases of the load, at the example's data except
// omega1, omega2: model/symmetric.hpp.
struct SymmetricEquations {
  const methods::Example& example;
  kernel::Variable tau{"tau"}, C{"C"}, omega1{"omega1"}, omega2{"omega2"}, sigma{"sigma"};
  kernel::Term Theta = 0;
  std::vector<kernel::Definition> rows;  // symmetric_row_1, symmetric_row_2: left C - right
  kernel::Term ur = 0;                   // by (12)

  explicit SymmetricEquations(const methods::Example& of);
  // Both rows are zero.
  [[nodiscard]] kernel::Formula hold(int phase, const kernel::Term& at_tau, const kernel::Term& at_C) const;
};

// The solutions for one phase of the load.
struct SymmetricList {
  std::vector<kernel::Variable> tau, C;
  std::vector<kernel::Formula> says;  // of each solution: where tau and C lie, and that the rows hold
  // Ranges of omega1 and omega2 ⊢ there are tau_1, C_1, tau_2, …: what is said, and for all 0 < tau < Theta
  // and all C: where the rows hold these are tau_1 and C_1, or tau_2 and C_2, or ….
  kernel::Theorem theorem;
};
// From numbers near all tau. Throws KernelError where there are other solutions, or it is not decided.
[[nodiscard]] SymmetricList symmetric_list(const SymmetricEquations& equations, int phase,
                                           const orbits::Ranges& frequencies,
                                           const std::vector<Rational>& nearly);

// Of an orbit of Fig. 2 the time lag, (pi - omega tau)/2; whether its phase is that and pi, and not that.
[[nodiscard]] Ball lag_of(const numeric::Orbit& orbit);
[[nodiscard]] bool has_the_other_phase(const numeric::Orbit& orbit);

// The list of the orbits of Fig. 2.
[[nodiscard]] ListTheorem list_of_S();

// All solutions of the reduced equations of nonsticking orbits at the data of an example, as a theorem.

// The list of the orbits of Fig. 4, where V = 0: that delta = pi/2 in all of them, and which mu they have
// (model/nonsticking.hpp).
[[nodiscard]] ListTheorem list_of_P();

}  // namespace stickslip::proofs::pascal2012
