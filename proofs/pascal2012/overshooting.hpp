// What Section 5 and Appendix 3 assume: slip on (0, tau), overshoot on (tau, tau + tau1), stick on (tau +
// tau1, Theta).
#pragma once

#include "proofs/pascal2012/half_period.hpp"
#include "proofs/symbols/closing.hpp"

namespace stickslip::proofs::pascal2012::overshooting {

using namespace symbols::vocabulary;
using namespace symbols::closing;

// The load's phase at tau and at tau + tau1.
inline const symbols::Term phiB = symbols::scalar("phiB"), phiC = symbols::scalar("phiC");

using half_period::begins;
using half_period::named_B;
using half_period::not_after;
using half_period::not_before;
using half_period::slip_takes_time;
using half_period::slips_below;
inline const methods::Assumption overshoots = half_period::slips_above_belt(tau, tau + tau1),
                                 sticks = half_period::sticks(tau + tau1, Theta);
inline const methods::Assumption overshoot_takes_time{"tau1.positive", {tau1, 0, symbols::Relation::greater}},
    stick_takes_time{"T.positive", {T, 0, symbols::Relation::greater}};
inline const methods::Assumption named_C{"19.ZC", symbols::equation(Z(tau + tau1), ZC)};
inline const methods::Assumption closes{"20", symbols::equation(Z(Theta), Z0)};
inline const methods::Assumption period{"20.T", symbols::equation(Theta, tau + tau1 + T)};
// Slip and overshoot; the stick that closes the motion; all three.
inline const std::vector<methods::Assumption> both_slips{
    begins, slips_below, named_B, overshoots, slip_takes_time, overshoot_takes_time, named_C},
    stick{named_C, sticks, stick_takes_time, closes, period};
[[nodiscard]] inline std::vector<methods::Assumption> whole_and(std::vector<methods::Assumption> more) {
  more.insert(more.begin(), stick.begin() + 1, stick.end());
  more.insert(more.begin(), both_slips.begin(), both_slips.end());
  return more;
}
// z2' = V at 0, tau and tau + tau1.
inline const methods::Assumption starts_with_belt{"12.V", symbols::equation(zdot20, V)};
inline const methods::Assumption meets_belt{"18.V", symbols::equation(zdot2B, V)};
inline const methods::Assumption lands_on_belt{"19.V", symbols::equation(symbols::scalar("zdot2C"), V)};

// chi eta (z2 - z1) - p cos(load): eta (r - u_s). (12), (18), (19).
[[nodiscard]] inline symbols::Term eta_r(const symbols::Term& z1, const symbols::Term& z2,
                                         const symbols::Term& load_phase) {
  return chi * eta * (z2 - z1) - p * cos(load_phase);
}
inline const symbols::Term load_at_C = omega * (tau + tau1) + phi;
inline const symbols::Statement at_start =
    symbols::equation(chi * eta * (z20 - z10), p * cos(phi) + eta * (ur - us));
inline const symbols::Statement inequality18{eta_r(z1B, z2B, omega * tau + phi) + eta * (ur + us), 0,
                                             symbols::Relation::less};
inline const symbols::Term middle19 = eta_r(z1C, z2C, load_at_C);
inline const symbols::Statement above19{-eta * (ur + us), middle19, symbols::Relation::less};
inline const symbols::Statement below19{middle19, eta *(ur - us), symbols::Relation::less};

// a_i z10 + b_i z20 + c_i z1'(0) + d_i.
[[nodiscard]] inline symbols::Term closing_form(int i) {
  return symbols::coefficient('a', i) * z10 + symbols::coefficient('b', i) * z20 +
         symbols::coefficient('c', i) * zdot10 + symbols::coefficient('d', i);
}

// A state without z2' that is even about the middle of the stick, from the even rows of
// model/overshooting_closing.hpp: a = lambda_2 P'_1, D = omega_2^2 omega_1 sin(alpha_1), C = V = 0 solve
// even_1, and leave -omega_1 omega_2 times this determinant of even_2; alpha_j = omega_j (tau + tau_1)/2.
inline const symbols::Term alpha1 = omega1 * (tau + tau1) / 2, alpha2 = omega2 * (tau + tau1) / 2;
inline const symbols::Term even_determinant = (lambda2 - lambda1) * cos(T / 2) * sin(alpha1) * sin(alpha2) +
                                              sin(T / 2) * (lambda2 * omega1 * cos(alpha1) * sin(alpha2) -
                                                            lambda1 * omega2 * cos(alpha2) * sin(alpha1));
inline const symbols::Term even_place =
    lambda2 * (omega1 * sin(alpha1) * cos(T / 2) + cos(alpha1) * sin(T / 2));
inline const symbols::Term even_swing = symbols::power(omega2, 2) * omega1 * sin(alpha1);
inline const symbols::Term even_state =
    symbols::column({chi * even_place + even_swing * cos(T / 2), even_place, -even_swing * sin(T / 2), 0});

}  // namespace stickslip::proofs::pascal2012::overshooting

namespace stickslip::proofs::pascal2012 {

[[nodiscard]] std::vector<methods::Claim> section5_linear();  // (21)-(23)
// (12), (18)-(20) are not enough for the overshoot and the stick.
[[nodiscard]] std::vector<methods::Claim> not_enough_for_three_phases();
[[nodiscard]] std::vector<methods::Claim> example_O();  // the orbit of Fig. 3
[[nodiscard]] methods::Claim spurious_zero();           // at its data: a zero of (23) that is no orbit

}  // namespace stickslip::proofs::pascal2012
