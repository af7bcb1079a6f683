// Symbols for the tests of this folder.
#pragma once

#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra::letters {

inline const GiNaC::ex a = symbol("a"), b = symbol("b"), s = symbol("s"), t = symbol("t"),
                       tau = symbol("tau"), phi = symbol("phi"), V = symbol("V"), chi = symbol("chi"),
                       eta = symbol("eta"), w = symbol("omega"), w1 = symbol("omega1"), w2 = symbol("omega2"),
                       l1 = symbol("lambda1"), l2 = symbol("lambda2");

}  // namespace stickslip::symbolic::algebra::letters
