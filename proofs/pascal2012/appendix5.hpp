// What Appendix 5 assumes: two slips of unknown lengths tau and tau_1, which close; V = 0.
#pragma once

#include "proofs/pascal2012/half_period.hpp"

namespace stickslip::proofs::pascal2012::two_slips {

using namespace symbols::vocabulary;
using half_period::begins;
using half_period::closes;
using half_period::first_row;
using half_period::half;
using half_period::meets_belt;
using half_period::named_B;
using half_period::not_after;
using half_period::not_before;
using half_period::overshoots;
using half_period::period;
using half_period::second_row;
using half_period::slip_takes_time;
using half_period::slips_below;
using half_period::starts_with_belt;

inline const methods::Assumption rest_of_period{"56.tau1", symbols::equation(Theta, tau + tau1)};
inline const methods::Assumption overshoot_takes_time{"tau1.positive", {tau1, 0, symbols::Relation::greater}};
inline const std::vector<methods::Assumption> cycle{
    rest_of_period,       period, begins, slips_below, overshoots, named_B, slip_takes_time,
    overshoot_takes_time, closes};
inline const methods::Assumption second_half{"67.tau1", symbols::equation(tau1, symbols::pi() / omega)};

inline const methods::Assumption regular_P{"65.det",
                                           {symbols::determinant(P), 0, symbols::Relation::not_equal}};
inline const methods::Assumption off_resonance{
    "70.resonance", {sin(omega1 * Theta / 2) * sin(omega2 * Theta / 2), 0, symbols::Relation::not_equal}};
inline const methods::Assumption at_rest{"A5.V", symbols::equation(V, 0)};
inline const methods::Assumption falls{"25.slip", {z20, z2B, symbols::Relation::greater}};
inline const methods::Assumption goes_down{
    "25.slope",
    symbols::during(0, tau, {symbols::block(1, {0, 0, 0, 1}) * X(t), V, symbols::Relation::less})};
inline const methods::Assumption regular_H1{
    "69.H1", {symbols::determinant(H1(tau) - I2), 0, symbols::Relation::not_equal}};

inline const symbols::Term phiB = omega * tau + phi;
inline const symbols::Term top = symbols::block(1, {I2, symbols::zero(2, 2)}),
                           bottom = symbols::block(1, {symbols::zero(2, 2), I2});

[[nodiscard]] inline std::vector<methods::Assumption> cycle_and(std::vector<methods::Assumption> more) {
  more.insert(more.begin(), cycle.begin(), cycle.end());
  return more;
}

// Both slips last half a period: that they last, and that the load repeats, follows.
[[nodiscard]] inline std::vector<methods::Assumption> halves_and(std::vector<methods::Assumption> more) {
  more.insert(more.begin(), {rest_of_period, half, second_half, begins, slips_below, overshoots, named_B,
                             closes, off_resonance});
  return more;
}

// (2) with Coulomb's law (4), u = u_s sign(V - x2'), for a motion that never sticks: at all times from 0 to
// the end but finitely many, at which x2' = V.
[[nodiscard]] methods::Assumption slips_with_friction(const std::string& id, const symbols::Term& motion,
                                                      const symbols::Term& speed, const symbols::Term& end);

// Off resonance both xi vanish, with no other hypothesis.
[[nodiscard]] std::vector<methods::Claim> weaker_hypotheses();
// What its theorem assumes: a cycle of two slips at V = 0, off resonance, with x2' < 0 on the first.
[[nodiscard]] std::vector<methods::Assumption> two_slips_at_rest();
// The same, at a time of the first slip.
[[nodiscard]] std::vector<methods::Assumption> in_first_half();
// (66)-(69) put together.
[[nodiscard]] std::vector<methods::Claim> theorem();
// For V > 0: tau > Theta/2.
[[nodiscard]] std::vector<methods::Claim> longer_slip();
// Why orbits that never stick attract.
[[nodiscard]] std::vector<methods::Claim> attraction();
// At most one motion that never sticks, by the energy of differences.
[[nodiscard]] std::vector<methods::Claim> uniqueness();

}  // namespace stickslip::proofs::pascal2012::two_slips
