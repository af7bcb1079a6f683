// What Eigen wants to know of a scalar that is no built-in number: Eigen::NumTraits<S> derives from this.
#pragma once

#include <Eigen/Core>

namespace stickslip::model {

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

}  // namespace stickslip::model
