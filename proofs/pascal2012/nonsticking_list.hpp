// All solutions of the reduced equations of nonsticking orbits at the data of an example, as a theorem.
#pragma once

#include "proofs/pascal2012/example_orbit.hpp"

namespace stickslip::proofs::pascal2012 {

// The list of the orbits of Fig. 4, where V = 0: that delta = pi/2 in all of them, and which mu they have
// (model/nonsticking.hpp).
[[nodiscard]] ListTheorem list_of_P();

}  // namespace stickslip::proofs::pascal2012
