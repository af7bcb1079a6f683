// The closing conditions of Section 5 as terms: slip on (0, tau), overshoot on (tau, tau + tau1), stick.
#pragma once

#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::symbols::closing {

using namespace vocabulary;

// The vector of four with 1 in place i, from 1, and the row that takes its component.
[[nodiscard]] inline std::vector<Term> unit(int i) {
  std::vector<Term> entries(4, Term(0));
  entries[static_cast<std::size_t>(i - 1)] = 1;
  return entries;
}
[[nodiscard]] inline Term row(int i) {
  return block(1, unit(i));
}
[[nodiscard]] inline Term place(int i) {
  return column(unit(i));
}

// The state after the slip (5), and after slip and overshoot, (5) and (8).
inline const Term after_slip = H(tau) * (Z0 - F0) + F(tau);
inline const Term after_both = H(tau + tau1) * (Z0 - F0) + 2 * L(tau1) * d0 + F(tau + tau1);

// What equation i of (21) says is zero: the components z1, z2, z1' of Z_C - Gamma(-T) Z_0, then z2' - V at
// tau and at tau + tau1.
[[nodiscard]] inline Term closing_gap(int i) {
  return i <= 3 ? row(i) * (after_both - Gamma(-T) * Z0) : row(4) * (i == 4 ? after_slip : after_both) - V;
}

// a_i, b_i, c_i are what stands beside z_1(0), z_2(0), z_1'(0) in it, with z_2'(0) = V, and d_i is the rest.
[[nodiscard]] inline Term coefficient_of_gap(char letter, int i) {
  const auto at = [&](int unknown) {
    std::vector<Term> state{0, 0, 0, V};
    if (unknown < 3) {
      state[static_cast<std::size_t>(unknown)] = 1;
    }
    return substitute(closing_gap(i), {{"Z0", column(state)}});
  };
  return letter == 'd' ? at(3) : at(letter - 'a') - at(3);
}

}  // namespace stickslip::proofs::symbols::closing
