// What Section 5 and Appendix 3 assume: slip on (0, tau), overshoot on (tau, tau + tau1), stick on (tau +
// tau1, Theta).
#pragma once

#include "proofs/abbreviations.hpp"
#include "proofs/claim.hpp"
#include "proofs/vocabulary.hpp"

namespace stickslip::proofs::overshooting {

using namespace vocabulary;

// The load's phase at tau and at tau + tau1.
inline const Term phiB = scalar("phiB"), phiC = scalar("phiC");

inline const Assumption named_B{"28.ZB", equation(Z(tau), ZB)};
inline const Assumption named_C{"19.ZC", equation(Z(tau + tau1), ZC)};
inline const Assumption closes{"20", equation(Z(Theta), Z0)};
inline const Assumption period{"20.T", equation(Theta, tau + tau1 + T)};
// z2' = V at 0, tau and tau + tau1.
inline const Assumption starts_with_belt{"12.V", equation(zdot20, V)};
inline const Assumption meets_belt{"18.V", equation(zdot2B, V)};
inline const Assumption lands_on_belt{"19.V", equation(scalar("zdot2C"), V)};

// Row i of a vector of four.
[[nodiscard]] inline Term row(int i) {
  std::vector<Term> entries(4, Term(0));
  entries[static_cast<std::size_t>(i - 1)] = 1;
  return block(1, std::move(entries));
}
// The vector with 1 in place i.
[[nodiscard]] inline Term place(int i) {
  std::vector<Term> entries(4, Term(0));
  entries[static_cast<std::size_t>(i - 1)] = 1;
  return column(std::move(entries));
}

// The state after the slip (5), and after slip and overshoot, (5) and (8).
inline const Term after_slip = H(tau) * (Z0 - F0) + F(tau);
inline const Term after_both = H(tau + tau1) * (Z0 - F0) + 2 * L(tau1) * d0 + F(tau + tau1);

// What equation i of (21) says is zero: the components z1, z2, z1' of Z_C - Gamma(-T) Z_0, then z2' - V at
// tau and at tau + tau1.
[[nodiscard]] inline Term closing_gap(int i) {
  return i <= 3 ? row(i) * (after_both - Gamma(-T) * Z0) : row(4) * (i == 4 ? after_slip : after_both) - V;
}

// a_i z10 + b_i z20 + c_i z1'(0) + d_i.
[[nodiscard]] inline Term closing_form(int i) {
  return coefficient('a', i) * z10 + coefficient('b', i) * z20 + coefficient('c', i) * zdot10 +
         coefficient('d', i);
}

}  // namespace stickslip::proofs::overshooting
