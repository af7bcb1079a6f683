// Free motion while the mass sticks to the belt: Gamma of (10), (41).
#pragma once

#include "model/slip.hpp"

namespace stickslip::model {

// (41): Sigma = [[1, chi], [0, 1]].
template <class S>
[[nodiscard]] Matrix2<S> Sigma(const S& chi) {
  return matrix<S>(S(1), chi, S(0), S(1));
}

// (41): gamma_2(t) = diag(sin t, t), gamma_1 = gamma_2', gamma_3 = gamma_2''.
template <class S>
[[nodiscard]] Blocks<S> gamma(const S& t) {
  using std::cos;
  using std::sin;
  const S s = S(sin(t));
  const S c = S(cos(t));
  return {diagonal<S>(c, S(1)), diagonal<S>(s, t), diagonal<S>(S(-s), S(0))};
}

// (41): Gamma_i(t) = Sigma gamma_i(t) Sigma⁻¹.
template <class S>
[[nodiscard]] Blocks<S> Gamma_blocks(const S& chi, const S& t) {
  const Matrix2<S> sigma = Sigma(chi);
  const Matrix2<S> sigma_inverse = inverse<S>(sigma);
  const Blocks<S> g = gamma(t);
  return {sigma * g.first * sigma_inverse, sigma * g.second * sigma_inverse, sigma * g.third * sigma_inverse};
}

// (10): the 4×4 flow of (9).
template <class S>
[[nodiscard]] Matrix4<S> Gamma(const S& chi, const S& t) {
  return assemble<S>(Gamma_blocks(chi, t));
}

}  // namespace stickslip::model
