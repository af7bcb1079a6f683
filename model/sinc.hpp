// Trigonometric functions that scalars may bring in a better form of their own, found by argument-dependent
// lookup: sinc(x) = sin(x)/x for scalars that have no sinc of their own, such as symbolic expressions, where
// x ≠ 0 is then a hypothesis. Numeric scalars bring theirs, with sinc(0) = 1, by argument-dependent lookup.
#pragma once

#include <cmath>
#include <utility>

namespace stickslip::model {

template <class S>
[[nodiscard]] S sinc(const S& x) {
  using std::sin;
  return S(sin(x)) / x;
}

[[nodiscard]] inline double sinc(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

// (sin x, cos x), for scalars that have them no cheaper together.
template <class S>
[[nodiscard]] std::pair<S, S> sin_cos(const S& x) {
  using std::cos;
  using std::sin;
  return {S(sin(x)), S(cos(x))};
}

}  // namespace stickslip::model
