// Where expressions are zero, on the domain 0 < omega1 < 1 < omega2 with positive omega, us, ur.
#pragma once

#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

// Whether a certificate shows that the expression is zero wherever the factor is: the expression, or its
// square, is a multiple of the factor, or the factor is linear in omega and the expression zero at its root.
// chi, eta, lambda1, lambda2 stand for (39). False says nothing.
[[nodiscard]] bool vanishes_with(const GiNaC::ex& expression, const GiNaC::ex& factor);

}  // namespace stickslip::symbolic::algebra
