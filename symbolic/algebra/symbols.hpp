// One GiNaC symbol per plain name, so that expressions built anywhere in the program mean the same things,
// and the values of expressions in balls.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>

#include "core/ball.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::symbolic::algebra {

// The symbol of that name; the same object on every call. Names are the paper's in ASCII: "omega1", "tau",
// "z10".
[[nodiscard]] GiNaC::ex symbol(const std::string& name);

// (39): chi, eta, lambda1 and lambda2 replaced by their rational expressions in omega1 and omega2.
[[nodiscard]] GiNaC::ex in_frequencies(const GiNaC::ex& expression);

using BallValues = std::map<GiNaC::ex, Ball, GiNaC::ex_is_less>;  // symbol -> value

// A ball that contains the value of the expression at the working precision; indeterminate where the
// expression is not defined. Handles rational numbers, symbols, π, + and *, rational powers with denominator
// 1 or 2, cos, sin and tan. Throws InternalError for anything else and for a symbol without value.
[[nodiscard]] Ball evaluate(const GiNaC::ex& expression, const BallValues& values);

// The exact rational value of a GiNaC rational number.
[[nodiscard]] Rational to_rational(const GiNaC::numeric& number);

// As GiNaC prints it, for messages.
[[nodiscard]] std::string plain(const GiNaC::ex& expression);

// All symbols that occur in the expression.
[[nodiscard]] GiNaC::exset symbols_of(const GiNaC::ex& expression);

}  // namespace stickslip::symbolic::algebra

// GiNaC expressions as a scalar of the model.
namespace Eigen {

template <>
struct NumTraits<GiNaC::ex> : stickslip::model::ScalarTraits<GiNaC::ex, 2, 100, 100> {};

}  // namespace Eigen
