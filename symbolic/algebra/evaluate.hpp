// GiNaC expressions evaluated in balls.
#pragma once

#include <map>
#include <string>

#include "core/ball.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra {

using BallValues = std::map<GiNaC::ex, Ball, GiNaC::ex_is_less>;  // symbol -> value

// A ball that contains the value of the expression at the working precision; indeterminate where the
// expression is not defined. Handles rational numbers, symbols, π, + and *, rational powers with denominator
// 1 or 2, cos, sin and tan. Throws InternalError for anything else and for a symbol without value.
[[nodiscard]] Ball evaluate(const GiNaC::ex& expression, const BallValues& values);

// The exact rational value of a GiNaC rational number, and back.
[[nodiscard]] Rational to_rational(const GiNaC::numeric& number);
[[nodiscard]] GiNaC::ex to_ex(const Rational& value);

// As GiNaC prints it, for messages.
[[nodiscard]] std::string plain(const GiNaC::ex& expression);

// All symbols that occur in the expression.
[[nodiscard]] GiNaC::exset symbols_of(const GiNaC::ex& expression);

}  // namespace stickslip::symbolic::algebra
