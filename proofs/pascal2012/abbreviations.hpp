// Names for what is long in many statements, for certificates and their readers.
#pragma once

#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::pascal2012 {

// Unit matrices and E; the matrices of X' = A X + … in slip and stick; and that a motion X obeys (2) with
// u = u_s or u = -u_s, or (9), from time a to time b: continuous there, with that derivative between. Later
// ones use earlier ones.
[[nodiscard]] std::vector<kernel::Definition> abbreviations();

}  // namespace stickslip::proofs::pascal2012
