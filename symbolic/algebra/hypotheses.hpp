// What an identity divides by: collected, factored, and discharged where it cannot vanish.
#pragma once

#include <vector>

#include "symbolic/algebra/scalar.hpp"

namespace stickslip::symbolic::algebra {

// The factors of the expression that may vanish somewhere on 0 < omega1 < 1 < omega2 with positive omega, us,
// ur, eta; empty if it cannot be zero there. chi, eta, lambda1, lambda2 stand for (39). A factor is
// discharged when the substitution omega1 = a/(1+a), omega2 = 1+b turns it into a polynomial in positive
// quantities whose coefficients have one sign. Sorted by their text, in a fixed sign. Throws OutsideField.
[[nodiscard]] std::vector<GiNaC::ex> vanishing_factors(const GiNaC::ex& expression);

// The vanishing factors of everything that stands in a denominator somewhere inside the expressions (tan
// divides by cos), each once.
[[nodiscard]] std::vector<GiNaC::ex> hypotheses_of(const std::vector<GiNaC::ex>& expressions);

}  // namespace stickslip::symbolic::algebra
