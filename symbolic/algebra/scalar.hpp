// GiNaC expressions as a scalar of the model.
#pragma once

#include <ginac/ginac.h>

#include "model/scalar_traits.hpp"

namespace Eigen {

template <>
struct NumTraits<GiNaC::ex> : stickslip::model::ScalarTraits<GiNaC::ex, 2, 100, 100> {};

}  // namespace Eigen
