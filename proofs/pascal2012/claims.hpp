// What the text of the paper (the files .claims) calls in C++: proofs, by the ids of their claims, which end
// in a line `by program`; and whole families of claims, which entries `program` name. They decide by orbits,
// lists and attractors, or take more than the methods of proof that a text can name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

using Proofs = std::map<std::string, methods::Proof>;

// What GiNaC derives; what the program computes with and what the proofs of orbits solve, against the paper.
[[nodiscard]] Proofs derived_forms();
[[nodiscard]] Proofs reduced();

// Frequencies in place of chi and eta; units of time.
[[nodiscard]] Proofs frequencies();

// The data of Fig. 2: what they and the printed values allow, what is printed for them against all orbits,
// where the determinant of (16) vanishes at them. Those of Fig. 4.
[[nodiscard]] Proofs data_of_S();
[[nodiscard]] Proofs against_the_list_of_S();
[[nodiscard]] Proofs zeros_of_16_at_S();
[[nodiscard]] Proofs data_of_P();
// Of Fig. 3: the printed values in (21)-(23); at its data: a zero of (23) that is no orbit.
[[nodiscard]] Proofs numbers_of_O();
[[nodiscard]] Proofs spurious_zero();

// Resonances, where omega_1 or omega_2 is a multiple of omega; slips on a belt that moves.
[[nodiscard]] Proofs resonances();
[[nodiscard]] Proofs longer_slip();
// What the abstract, Section 6 and the conclusion assert about orbits; "V.motion".
[[nodiscard]] Proofs cycles();

// The printed values of an example's orbit; what its values were computed from, and all else of the orbit. Of
// O what they were computed from is told last.
[[nodiscard]] std::vector<methods::Claim> values_of_S();
[[nodiscard]] std::vector<methods::Claim> orbit_of_S();
[[nodiscard]] std::vector<methods::Claim> values_of_P();
[[nodiscard]] std::vector<methods::Claim> orbit_of_P();
[[nodiscard]] std::vector<methods::Claim> orbit_of_O();
[[nodiscard]] std::vector<methods::Claim> origins_of_O();
// "S.attractors", …: what motions from random starts end on, and whether most of all on the figure's orbit,
// or none: a check.
[[nodiscard]] std::vector<methods::Claim> attractors();

// Names for what is long in many statements, for certificates and their readers.
// Unit matrices and E; the matrices of X' = A X + … in slip and stick; and that a motion X obeys (2) with
// u = u_s or u = -u_s, or (9), from time a to time b: continuous there, with that derivative between. Later
// ones use earlier ones.
[[nodiscard]] std::vector<kernel::Definition> abbreviations();

}  // namespace stickslip::proofs::pascal2012
