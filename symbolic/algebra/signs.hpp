// Where expressions are zero and of which sign they are, on the domain 0 < omega1 < 1 < omega2 with positive
// omega, us, ur.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

// Whether a certificate shows that the expression is zero wherever the factor is: the expression, or its
// square, is a multiple of the factor, or the factor is linear in omega and the expression zero at its root.
// chi, eta, lambda1, lambda2 stand for (39). False says nothing.
[[nodiscard]] bool vanishes_with(const GiNaC::ex& expression, const GiNaC::ex& factor);

// If the expression is certainly positive where certain factors are not zero: these factors, as
// vanishing_factors() gives them. The factors that occur to an odd power must be of one sign, which is then
// evaluated at one point of the domain, which is connected. Nothing says nothing.
[[nodiscard]] std::optional<std::vector<GiNaC::ex>> positive_unless_zero(const GiNaC::ex& expression);

}  // namespace stickslip::symbolic::algebra
