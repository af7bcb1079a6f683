// One GiNaC symbol per plain name, so that expressions built anywhere in the program mean the same things.
#pragma once

#include <ginac/ginac.h>

#include <string>

#include "model/scalar_traits.hpp"

namespace stickslip::symbolic::algebra {

// The symbol of that name; the same object on every call. Names are the paper's in ASCII: "omega1", "tau",
// "z10".
[[nodiscard]] GiNaC::ex symbol(const std::string& name);

// (39): chi, eta, lambda1 and lambda2 replaced by their rational expressions in omega1 and omega2.
[[nodiscard]] GiNaC::ex in_frequencies(const GiNaC::ex& expression);

}  // namespace stickslip::symbolic::algebra

// GiNaC expressions as a scalar of the model.
namespace Eigen {

template <>
struct NumTraits<GiNaC::ex> : stickslip::model::ScalarTraits<GiNaC::ex, 2, 100, 100> {};

}  // namespace Eigen
