// What Appendix 5 assumes: two slips of unknown lengths tau and tau_1, which close; V = 0.
#pragma once

#include "proofs/half_period.hpp"

namespace stickslip::proofs::two_slips {

using namespace vocabulary;
using half_period::closes;
using half_period::first_row;
using half_period::half;
using half_period::meets_belt;
using half_period::named_B;
using half_period::period;
using half_period::second_row;
using half_period::starts_with_belt;

inline const Assumption rest_of_period{"56.tau1", equation(Theta, tau + tau1)};
// Theta = 2 pi/omega is used in this form and, for sin(omega_j pi/omega), as Theta/2 = pi/omega.
inline const Assumption load_repeats{"28.Theta", equation(F(Theta), F0)};
inline const std::vector<Assumption> cycle{rest_of_period, load_repeats, closes, named_B};
inline const Assumption second_half{"67.tau1", equation(tau1, pi() / omega)};

inline const Assumption regular_P{"65.det", {determinant(P), 0, Relation::not_equal}};
inline const Assumption off_resonance{
    "70.resonance", {sin(omega1 * Theta / 2) * sin(omega2 * Theta / 2), 0, Relation::not_equal}};
inline const Assumption at_rest{"A5.V", equation(V, 0)};
inline const Assumption falls{"25.slip", {z20, z2B, Relation::greater}};
inline const Assumption regular_H1{"69.H1", {determinant(H1(tau) - I2), 0, Relation::not_equal}};

inline const Term phiB = omega * tau + phi;
inline const Term top = block(1, {I2, zero(2, 2)}), bottom = block(1, {zero(2, 2), I2});

[[nodiscard]] inline std::vector<Assumption> cycle_and(std::vector<Assumption> more) {
  more.insert(more.begin(), cycle.begin(), cycle.end());
  return more;
}

// Off resonance both xi vanish, with no other hypothesis.
[[nodiscard]] std::vector<Claim> weaker_hypotheses();
// What its theorem assumes: a cycle of two slips at V = 0, off resonance, with x2' < 0 on the first.
[[nodiscard]] std::vector<Assumption> two_slips_at_rest();
// (66)-(69) put together.
[[nodiscard]] std::vector<Claim> theorem();
// At most one motion that never sticks, by the energy of differences.
[[nodiscard]] std::vector<Claim> uniqueness();

}  // namespace stickslip::proofs::two_slips
