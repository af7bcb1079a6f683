// Closed forms in the paper's symbols, derived from its equations of motion by symbolic/ without any formula
// of model/.
#pragma once

#include "symbolic/algebra/decide.hpp"
#include "symbolic/algebra/derive.hpp"

namespace stickslip::proofs::methods {

// exp(t [[0, I], [-K, 0]]) in omega1, omega2 and t.
[[nodiscard]] symbolic::algebra::Matrix slip_exponential();

// exp(t A) for the first-order form of (9), in chi and t.
[[nodiscard]] symbolic::algebra::Matrix stick_exponential();

// The solution (q1, q2) of (K - omega² I) Q = (0, p), in omega1, omega2, omega, p.
[[nodiscard]] symbolic::algebra::Matrix forced_amplitudes();

// The second components of the eigenvectors (1, lambda_j) of K, in omega1, omega2: one column.
[[nodiscard]] symbolic::algebra::Matrix eigenvector_slopes();

// chi and eta from Vieta's equations for det(K - s² I), in omega1, omega2: one column.
[[nodiscard]] symbolic::algebra::Matrix vieta_solution();

}  // namespace stickslip::proofs::methods
