// What the paper assumes of its motions, and what Section 6 and Appendix 4 do: two slips of half a period
// each, which close.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012::half_period {

using namespace symbols::vocabulary;

// The motion X = (x, x') obeys (2) from one time to another, with u = u_s or u = -u_s; or (9).
[[nodiscard]] inline methods::Assumption slips(const std::string& id, const symbols::Term& friction,
                                               const symbols::Term& from, const symbols::Term& to) {
  const symbols::Term force = friction + p * cos(omega * t + phi);
  return {id, during(from, to,
                     equation(derivative(X(t)), first_order(K) * X(t) + symbols::column({0, 0, 0, force})))};
}
[[nodiscard]] inline methods::Assumption slips_below_belt(const symbols::Term& from,
                                                          const symbols::Term& to) {
  return slips("2.slip", eta * us, from, to);
}
[[nodiscard]] inline methods::Assumption slips_above_belt(const symbols::Term& from,
                                                          const symbols::Term& to) {
  return slips("2.overshoot", -(eta * us), from, to);
}
[[nodiscard]] inline methods::Assumption sticks(const symbols::Term& from, const symbols::Term& to) {
  return {"9.stick", during(from, to, equation(derivative(X(t)), first_order(stick_matrix) * X(t)))};
}
// A time that is not before or not after another.
[[nodiscard]] inline methods::Assumption not_before(const symbols::Term& time, const symbols::Term& from) {
  return {"t.from", {from, time, symbols::Relation::less_or_equal}};
}
[[nodiscard]] inline methods::Assumption not_after(const symbols::Term& time, const symbols::Term& to) {
  return {"t.to", {time, to, symbols::Relation::less_or_equal}};
}

inline const methods::Assumption begins{"6.Z0", symbols::equation(Z(0), Z0)};
inline const methods::Assumption slip_takes_time{"tau.positive", {tau, 0, symbols::Relation::greater}};
inline const methods::Assumption slips_below = slips_below_belt(0, tau),
                                 overshoots = slips_above_belt(tau, Theta);

inline const methods::Assumption half{"26.half", symbols::equation(tau, symbols::pi() / omega)};
inline const methods::Assumption period{"28.period", symbols::equation(Theta, 2 * symbols::pi() / omega)};
inline const methods::Assumption closes{"28.closes", symbols::equation(Z(Theta), Z0)};
inline const methods::Assumption named_B{"28.ZB", symbols::equation(Z(tau), ZB)};
// Both slips, and that they close.
inline const std::vector<methods::Assumption> motion{half,       period,  begins, slips_below,
                                                     overshoots, named_B, closes};
[[nodiscard]] inline std::vector<methods::Assumption> motion_and(std::vector<methods::Assumption> more) {
  more.insert(more.begin(), motion.begin(), motion.end());
  return more;
}

inline const methods::Assumption regular{"31.regular",
                                         {symbols::determinant(H3(tau)), 0, symbols::Relation::not_equal}};
inline const methods::Assumption starts_with_belt{"25.V", symbols::equation(zdot20, V)};
inline const methods::Assumption meets_belt{"26.V", symbols::equation(symbols::scalar("zdot2B"), V)};

// (4): r = chi (x2 - x1) - (p/eta) cos(omega t + phi), with x = z + d_0.
[[nodiscard]] inline symbols::Term friction_at_rest(const symbols::Term& z1, const symbols::Term& z2,
                                                    const symbols::Term& load_phase) {
  return chi * (z2 + d02 - z1 - d01) - p / eta * cos(load_phase);
}

inline const symbols::Statement inequality25{chi * eta * (z20 - z10), p * cos(phi) + eta *(ur - us),
                                             symbols::Relation::greater};
inline const symbols::Statement inequality26{
    chi * eta * (z2B - z1B), p * cos(omega * tau + phi) - eta *(ur + us), symbols::Relation::less};
inline const symbols::Statement inequality36{chi * eta * (q2 - q1) * cos(phi) - p * cos(phi) - eta * ur, 0,
                                             symbols::Relation::greater};

// b_1 d_01 + b_2 d_02, which is -q_2 omega sin(phi) by (35); and p/(q_2 omega), by (7).
inline const symbols::Term B = b1 * d01 + b2 * d02;
inline const symbols::Term D = (power(omega, 2) - power(omega1, 2)) * (power(omega, 2) - power(omega2, 2)),
                           bound = D / (omega * (1 - power(omega, 2)));
inline const methods::Assumption load_acts{"1.p", {p, 0, symbols::Relation::greater}};
inline const symbols::Statement inequality37{p, abs(D * B / ((1 - power(omega, 2)) * omega)),
                                             symbols::Relation::greater};

inline const symbols::Term first_row = symbols::block(1, {1, 0}), second_row = symbols::block(1, {0, 1});
inline const symbols::Term H2_inverse = symbols::inverse(H2(tau));

// The two terms of the first of (30) in modal coordinates.
inline const symbols::Term modal_speed = symbols::inverse(Lambda) * (zdotB - Q * omega * sin(phi));
inline const symbols::Term modal_rest = symbols::inverse(Lambda) * d0;

// z_0' of (33), with Lambda diag(-phi_j) Lambda^{-1} for H_2^{-1}(H_1 - I).
inline const symbols::Term speed_continued =
    -Q * omega * sin(phi) - Lambda * symbols::block(2, {phi1, 0, 0, phi2}) * symbols::inverse(Lambda) * d0;

// A component of the state that (33) gives.
[[nodiscard]] inline methods::Assumption continued(const symbols::Term& component,
                                                   const symbols::Term& value) {
  return {"33", symbols::equation(component, value)};
}

// (36), (37): which loads keep the mass from sticking.
[[nodiscard]] std::vector<methods::Claim> section6_load();
// Where omega_1 or omega_2 is an odd multiple of omega there is none.
[[nodiscard]] methods::Claim odd_resonance();
// Orbits that never stick and are not symmetric, where omega_1 = 2 omega.
[[nodiscard]] std::vector<methods::Claim> even_resonance();
// (25)-(37) are not enough for the two slips.
[[nodiscard]] std::vector<methods::Claim> not_enough_for_slips();
// So what the paper says of all of them has exceptions.
[[nodiscard]] methods::Claim not_always_symmetric();
// An orbit that never sticks on a belt that moves, where omega_1 = 2 omega.
[[nodiscard]] methods::Claim only_at_rest_by_halves();
// How long the orbit of Fig. 4 lives on a belt that moves.
[[nodiscard]] methods::Claim orbits_over_the_belts_speed();
// The orbit of Fig. 4.
[[nodiscard]] std::vector<methods::Claim> example_P();

}  // namespace stickslip::proofs::pascal2012::half_period
