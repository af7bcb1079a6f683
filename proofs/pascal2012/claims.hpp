// Claims of the paper, and proofs of some, that C++ makes: those that orbits, lists and attractors decide,
// and those that take more than the methods of proof that a text can name. The text (the files .claims) says
// where they stand.
#pragma once

#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

// The proofs of 39.derived, 6.H, 7 and 10.Gamma.
[[nodiscard]] std::vector<methods::Claim> derived_forms();
// "51.formulas": what the program computes with are the coefficients that are printed.
[[nodiscard]] methods::Claim computed_coefficients();
// What the proofs of orbits solve in place of (13)-(28).
[[nodiscard]] std::vector<methods::Claim> reduced();

// The orbit of Fig. 2; what its data allow: u_r is one of them; what is printed for it, against all orbits.
[[nodiscard]] std::vector<methods::Claim> example_S();
[[nodiscard]] std::vector<methods::Claim> data_of_S();
[[nodiscard]] std::vector<methods::Claim> friction_of_S();
[[nodiscard]] std::vector<methods::Claim> printed_orbits_of_S();
// "S.det": where the determinant of (16) vanishes at its data.
[[nodiscard]] methods::Claim zeros_of_16_at_S();

// The orbit of Fig. 3; at its data: a zero of (23) that is no orbit.
[[nodiscard]] std::vector<methods::Claim> example_O();
[[nodiscard]] methods::Claim spurious_zero();

// The orbit of Fig. 4; how long it lives on a belt that moves.
[[nodiscard]] std::vector<methods::Claim> example_P();
[[nodiscard]] methods::Claim orbits_over_the_belts_speed();

// The proof of 31.odd: where omega_1 or omega_2 is an odd multiple of omega no motion closes.
[[nodiscard]] methods::Claim odd_resonance();
// "33.even.orbits": orbits that never stick and are not symmetric, where omega_1 = 2 omega; "7.exception": so
// what the paper says of all of them has exceptions.
[[nodiscard]] methods::Claim even_resonance();
[[nodiscard]] methods::Claim not_always_symmetric();
// An orbit that never sticks on a belt that moves, where omega_1 = 2 omega.
[[nodiscard]] methods::Claim only_at_rest_by_halves();
// The proofs of A5.tan and A5.longer: for V > 0, tau > Theta/2.
[[nodiscard]] std::vector<methods::Claim> longer_slip();

// What the abstract, Section 6 and the conclusion assert about orbits and attractors; "V.motion".
[[nodiscard]] std::vector<methods::Claim> cycles();
[[nodiscard]] methods::Claim motion_on_moving_belt();

}  // namespace stickslip::proofs::pascal2012
