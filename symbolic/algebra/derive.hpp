// Closed forms derived from the equations of motion by a route that shares no formula with model/:
// frequencies from the characteristic polynomial, eigenvectors by elimination, flows as exponentials of
// first-order systems.
#pragma once

#include "model/parameters.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra {

using Matrix2 = model::Matrix2<GiNaC::ex>;
using Matrix4 = model::Matrix4<GiNaC::ex>;

// det(K - s² I), expanded: a polynomial in s.
[[nodiscard]] GiNaC::ex characteristic_polynomial(const Matrix2& K, const GiNaC::ex& s);

// chi and eta such that the characteristic polynomial of K(chi, eta) is (s² - omega1²)(s² - omega2²): the
// solution of Vieta's equations, which is unique where chi*eta ≠ 0.
struct Inverted {
  GiNaC::ex chi;
  GiNaC::ex eta;
};
[[nodiscard]] Inverted solve_vieta(const GiNaC::ex& omega1, const GiNaC::ex& omega2);

// The second component of the eigenvector (1, lambda) of K for the eigenvalue omega_j², from the first row of
// (K - omega_j² I)(1, lambda)ᵀ = 0. Assumes K_12 ≠ 0.
[[nodiscard]] GiNaC::ex eigenvector_slope(const Matrix2& K, const GiNaC::ex& omega_j);

// A pair of purely imaginary eigenvalues ±i*frequency (frequency ≠ 0), or the eigenvalue 0 of some
// multiplicity.
struct Spectrum {
  std::vector<GiNaC::ex> frequencies;  // distinct, each simple
  int zeros = 0;
};

// exp(A t) for a 4×4 matrix with that spectrum: inverse Laplace transform of the resolvent (sI - A)⁻¹ by
// partial fractions. Throws InternalError if the spectrum is not that of A.
[[nodiscard]] Matrix4 exponential(const Matrix4& A, const Spectrum& spectrum, const GiNaC::ex& t);

// The first-order form of x'' + M x = 0: d/dt (x, x') = [[0, I], [-M, 0]] (x, x').
[[nodiscard]] Matrix4 first_order(const Matrix2& M);

}  // namespace stickslip::symbolic::algebra
