// What the model asks of scalars that are no built-in numbers.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace stickslip::model {

// What Eigen wants to know of a scalar that is no built-in number: Eigen::NumTraits<S> derives from this.

// The costs, in additions of built-in numbers, tell Eigen which loops to unroll.
template <class S, int read_cost, int add_cost, int multiply_cost>
struct ScalarTraits : Eigen::GenericNumTraits<S> {
  using Real = S;
  using NonInteger = S;
  using Nested = S;
  using Literal = S;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = read_cost,
    AddCost = add_cost,
    MulCost = multiply_cost
  };
};

// Trigonometric functions that scalars may bring in a better form of their own, found by argument-dependent
// lookup: sinc(x) = sin(x)/x for scalars that have no sinc of their own, such as symbolic expressions, where
// x ≠ 0 is then a hypothesis. Numeric scalars bring theirs, with sinc(0) = 1, by argument-dependent lookup.

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
