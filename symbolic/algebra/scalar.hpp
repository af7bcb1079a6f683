// GiNaC expressions as a scalar of the model.
#pragma once

#include <ginac/ginac.h>

#include <Eigen/Core>

namespace Eigen {

template <>
struct NumTraits<GiNaC::ex> : GenericNumTraits<GiNaC::ex> {
  using Real = GiNaC::ex;
  using NonInteger = GiNaC::ex;
  using Nested = GiNaC::ex;
  using Literal = GiNaC::ex;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 100,
    MulCost = 100
  };
};

}  // namespace Eigen
