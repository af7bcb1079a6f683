#include "symbolic/algebra/derive.hpp"

#include "core/error.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;

// One term of a partial fraction, 1/(s² + w²) etc., multiplied by the common denominator, and what it is the
// Laplace transform of.
struct Transform {
  ex transform;  // polynomial in s
  ex original;   // function of t
};

ex common_denominator(const Spectrum& spectrum, const ex& s) {
  ex result = GiNaC::pow(s, spectrum.zeros);
  for (const ex& w : spectrum.frequencies) {
    result *= s * s + w * w;
  }
  return result;
}

std::vector<Transform> fractions(const Spectrum& spectrum, const ex& s, const ex& t) {
  const ex denominator = common_denominator(spectrum, s);
  std::vector<Transform> result;
  for (const ex& w : spectrum.frequencies) {
    const ex rest = denominator / (s * s + w * w);
    result.push_back({(rest * s).expand(), GiNaC::cos(w * t)});
    result.push_back({rest.expand(), GiNaC::sin(w * t) / w});
  }
  for (int k = 1; k <= spectrum.zeros; ++k) {
    result.push_back(
        {(denominator / GiNaC::pow(s, k)).expand(), GiNaC::pow(t, k - 1) / GiNaC::factorial(k - 1)});
  }
  return result;
}

// numerator/denominator as a combination of the fractions, transformed back.
ex inverse_transform(const ex& numerator, const std::vector<Transform>& parts, const ex& s) {
  GiNaC::lst unknowns;
  ex combination = 0;
  ex original = 0;
  for (const Transform& part : parts) {
    const ex coefficient = GiNaC::symbol();
    unknowns.append(coefficient);
    combination += coefficient * part.transform;
    original += coefficient * part.original;
  }
  const ex difference = (combination - numerator).expand();
  if (difference.degree(s) >= static_cast<int>(parts.size())) {
    throw InternalError("the spectrum given is not that of the matrix");
  }
  GiNaC::lst equations;
  for (int k = 0; k < static_cast<int>(parts.size()); ++k) {
    equations.append(difference.coeff(s, k) == 0);
  }
  const ex solution = GiNaC::lsolve(equations, unknowns);
  return original.subs(solution);
}

GiNaC::matrix to_ginac(const Matrix4& m) {
  GiNaC::matrix result(4, 4);
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = 0; j < 4; ++j) {
      result(i, j) = m(i, j);
    }
  }
  return result;
}

}  // namespace

ex characteristic_polynomial(const Matrix2& K, const ex& s) {
  const GiNaC::matrix shifted{{K(0, 0) - s * s, K(0, 1)}, {K(1, 0), K(1, 1) - s * s}};
  return shifted.determinant().expand();
}

Inverted solve_vieta(const ex& omega1, const ex& omega2) {
  const GiNaC::symbol chi("chi"), eta("eta"), s("s");
  const ex polynomial = characteristic_polynomial(model::stiffness<ex>(chi, eta), s);
  const ex wanted = ((s * s - omega1 * omega1) * (s * s - omega2 * omega2)).expand();
  const ex difference = (polynomial - wanted).expand();
  // The coefficient of s² gives eta; with it the constant one, divided by chi*eta, is linear in chi.
  const ex eta_of_chi = GiNaC::lsolve(difference.coeff(s, 2) == 0, eta);
  const ex constant = difference.coeff(s, 0).subs(eta == eta_of_chi).normal();
  const ex chi_value = GiNaC::lsolve(constant.numer().expand() == 0, chi);
  return {chi_value.normal(), eta_of_chi.subs(chi == chi_value).normal()};
}

ex eigenvector_slope(const Matrix2& K, const ex& omega_j) {
  const GiNaC::symbol slope;
  return GiNaC::lsolve(K(0, 0) - omega_j * omega_j + K(0, 1) * slope == 0, slope);
}

Matrix4 exponential(const Matrix4& A, const Spectrum& spectrum, const ex& t) {
  const GiNaC::symbol s("s");
  const GiNaC::matrix identity = ex_to<GiNaC::matrix>(GiNaC::unit_matrix(4));
  const GiNaC::matrix resolvent = identity.mul_scalar(s).sub(to_ginac(A)).inverse();
  const ex denominator = common_denominator(spectrum, s);
  const std::vector<Transform> parts = fractions(spectrum, s, t);
  Matrix4 result;
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = 0; j < 4; ++j) {
      const ex numerator = (resolvent(i, j) * denominator).normal();
      if (!numerator.is_polynomial(s)) {
        throw InternalError("the spectrum given is not that of the matrix");
      }
      result(i, j) = inverse_transform(numerator, parts, s);
    }
  }
  return result;
}

Matrix4 first_order(const Matrix2& M) {
  const Matrix2 zero = Matrix2::Constant(ex(0));
  const Matrix2 minus_M = M * ex(-1);
  return model::blocks<ex>(zero, model::identity2<ex>(), minus_M, zero);
}

}  // namespace stickslip::symbolic::algebra
