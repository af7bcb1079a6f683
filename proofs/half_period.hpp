// What Section 6 and Appendix 4 assume: two slips of half a period each, which close.
#pragma once

#include "proofs/claim.hpp"
#include "proofs/vocabulary.hpp"

namespace stickslip::proofs::half_period {

using namespace vocabulary;

inline const Assumption half{"26.half", equation(tau, pi() / omega)};
inline const Assumption period{"28.period", equation(Theta, 2 * pi() / omega)};
inline const Assumption closes{"28.closes", equation(Z(Theta), Z0)};
inline const Assumption named_B{"28.ZB", equation(Z(tau), ZB)};
inline const Assumption regular{"31.regular", {determinant(H3(tau)), 0, Relation::not_equal}};
inline const Assumption starts_with_belt{"25.V", equation(zdot20, V)};
inline const Assumption meets_belt{"26.V", equation(scalar("zdot2B"), V)};

// (4): r = chi (x2 - x1) - (p/eta) cos(omega t + phi), with x = z + d_0.
[[nodiscard]] inline Term friction_at_rest(const Term& z1, const Term& z2, const Term& load_phase) {
  return chi * (z2 + d02 - z1 - d01) - p / eta * cos(load_phase);
}

inline const Statement inequality25{chi * eta * (z20 - z10), p* cos(phi) + eta*(ur - us), Relation::greater};
inline const Statement inequality26{chi * eta * (z2B - z1B), p* cos(omega* tau + phi) - eta*(ur + us),
                                    Relation::less};
inline const Statement inequality36{chi * eta * (q2 - q1) * cos(phi) - p * cos(phi) - eta * ur, 0,
                                    Relation::greater};

inline const Term first_row = block(1, {1, 0}), second_row = block(1, {0, 1});
inline const Term H2_inverse = inverse(H2(tau));

// The two terms of the first of (30) in modal coordinates.
inline const Term modal_speed = inverse(Lambda) * (zdotB - Q * omega * sin(phi));
inline const Term modal_rest = inverse(Lambda) * d0;

// z_0' of (33), with Lambda diag(-phi_j) Lambda^{-1} for H_2^{-1}(H_1 - I).
inline const Term speed_continued =
    -Q * omega * sin(phi) - Lambda * block(2, {phi1, 0, 0, phi2}) * inverse(Lambda) * d0;

// A component of the state that (33) gives.
[[nodiscard]] inline Assumption continued(const Term& component, const Term& value) {
  return {"33", equation(component, value)};
}

// (36), (37): which loads keep the mass from sticking.
[[nodiscard]] std::vector<Claim> section6_load();
// The orbit of Fig. 4.
[[nodiscard]] std::vector<Claim> example_P();

}  // namespace stickslip::proofs::half_period
