// (16) as linear equations for z1(0), z2(0) and z1'(0): their matrix, and that without the cosines.
#pragma once

#include "proofs/pascal2012/symmetric.hpp"

namespace stickslip::proofs::pascal2012::determinant16 {

using namespace symbols;
using namespace symmetric;

[[nodiscard]] inline Term diagonal(const Term& a, const Term& b) {
  return block(2, {a, 0, 0, b});
}

inline const Term alpha1 = omega1 * tau / 2, alpha2 = omega2 * tau / 2, half_T = T / 2;
inline const Term first = column({1, 0}), belt = column({0, V});
// What stands beside the unknowns and alone: each equation is (a row) (z1(0), z2(0), z1'(0), 1) = 0.
[[nodiscard]] inline Term rows(const Term& of_place, const Term& of_speed, const Term& load_place,
                               const Term& load_speed) {
  return block(1, {of_place, of_speed * first, of_speed * (belt + load_speed) - of_place * load_place});
}
inline const Term slip_load = Q * sin(omega * tau / 2), slip_load_speed = Q * omega * cos(omega * tau / 2);
inline const Term of_16 = block(2, {rows(H1(tau) + I2, H2(tau), slip_load, slip_load_speed),
                                    rows(Gamma1(T) + I2, -Gamma2(T), zero(2, 1), zero(2, 1))});

// The halves that are left when the cosines are divided out.
inline const Term of_halves =
    block(2, {rows(diagonal(omega1 * cos(alpha1), omega2 * cos(alpha2)) * inverse(Lambda),
                   diagonal(sin(alpha1), sin(alpha2)) * inverse(Lambda), slip_load, slip_load_speed),
              rows(diagonal(cos(half_T), 2) * inverse(Sigma), -diagonal(sin(half_T), T) * inverse(Sigma),
                   zero(2, 1), zero(2, 1))});

}  // namespace stickslip::proofs::pascal2012::determinant16

namespace stickslip::proofs::pascal2012 {

// "S.det": where the determinant vanishes at the data of Fig. 2.
[[nodiscard]] methods::Claim zeros_of_16_at_S();

}  // namespace stickslip::proofs::pascal2012
