// What Section 4 and Appendix 2 assume: a slip that ends in the state E Z_0, and a stick that leads back.
#pragma once

#include "proofs/methods/claim.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012::symmetric {

using namespace symbols::vocabulary;
using half_period::begins;
using half_period::closes;
using half_period::friction_at_rest;
using half_period::not_after;
using half_period::not_before;
using half_period::period;
using half_period::slip_takes_time;
using half_period::slips_below;
using half_period::starts_with_belt;

inline const methods::Assumption time_lag{"4.lag", symbols::equation(phi, (symbols::pi() - omega * tau) / 2)};
inline const methods::Assumption slip_ends{"13", symbols::equation(Z(tau), E * Z0)};
inline const methods::Assumption stick_ends{"15", symbols::equation(Gamma(T) * E * Z0, Z0)};
inline const methods::Assumption stick_lasts{"4.T", symbols::equation(T, Theta - tau)};
inline const methods::Assumption stick_takes_time{"T.positive", {T, 0, symbols::Relation::greater}};
inline const methods::Assumption sticks = half_period::sticks(tau, Theta);

// Zero where omega_j tan(omega_j tau/2) = omega tan(omega tau/2).
[[nodiscard]] inline symbols::Term balance(const symbols::Term& frequency) {
  return frequency * sin(frequency * tau / 2) * cos(omega * tau / 2) -
         omega * cos(frequency * tau / 2) * sin(omega * tau / 2);
}

}  // namespace stickslip::proofs::pascal2012::symmetric

namespace stickslip::proofs::pascal2012 {

// Where (16) can be solved, and where that is an orbit.
[[nodiscard]] std::vector<methods::Claim> determinant_of_16();
// The orbit of Fig. 2.
[[nodiscard]] std::vector<methods::Claim> example_S();
// What its data allow: u_r is one of them.
[[nodiscard]] std::vector<methods::Claim> data_of_S();
// That u_r is one of its data; what is printed for it, against all orbits.
[[nodiscard]] std::vector<methods::Claim> friction_of_S();
[[nodiscard]] std::vector<methods::Claim> printed_orbits_of_S();

}  // namespace stickslip::proofs::pascal2012
