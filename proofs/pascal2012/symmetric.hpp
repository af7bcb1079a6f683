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

// (12), the middle of (14), (13) in closed form, and (16).
inline const symbols::Statement equation12 =
    symbols::equation(chi * eta * (z20 - z10), p * cos(phi) + eta * (ur - us));
inline const symbols::Term at_C = chi * eta * (z2C - z1C) - p * cos(omega * tau + phi);
inline const symbols::Statement slip13 = symbols::equation(H(tau) * (Z0 - F0) + F(tau), E * Z0);
inline const symbols::Term s0 = symbols::scalar("s0"), c0 = symbols::scalar("c0");
inline const methods::Assumption half_sine{"16.s0", symbols::equation(s0, sin(omega *tau / 2))},
    half_cosine{"16.c0", symbols::equation(c0, cos(omega *tau / 2))};
inline const symbols::Statement slip16 = symbols::equation(
                                    (H1(tau) + I2) * (z0 - Q * s0) + H2(tau) * (zdot0 + Q * omega * c0),
                                    symbols::zero(2, 1)),
                                stick16 = symbols::equation((Gamma1(T) + I2) * z0 - Gamma2(T) * zdot0,
                                                            symbols::zero(2, 1));

// Zero where omega_j tan(omega_j tau/2) = omega tan(omega tau/2).
[[nodiscard]] inline symbols::Term balance(const symbols::Term& frequency) {
  return frequency * sin(frequency * tau / 2) * cos(omega * tau / 2) -
         omega * cos(frequency * tau / 2) * sin(omega * tau / 2);
}

}  // namespace stickslip::proofs::pascal2012::symmetric

namespace stickslip::proofs::pascal2012 {

// Where (16) can be solved, and where that is an orbit.
[[nodiscard]] std::vector<methods::Claim> determinant_of_16();
// (12)-(16) are not enough for the slip and the stick.
[[nodiscard]] std::vector<methods::Claim> not_enough_for_slip_and_stick();
// The orbit of Fig. 2.
[[nodiscard]] std::vector<methods::Claim> example_S();
// What its data allow: u_r is one of them.
[[nodiscard]] std::vector<methods::Claim> data_of_S();
// That u_r is one of its data; what is printed for it, against all orbits.
[[nodiscard]] std::vector<methods::Claim> friction_of_S();
[[nodiscard]] std::vector<methods::Claim> printed_orbits_of_S();

}  // namespace stickslip::proofs::pascal2012
