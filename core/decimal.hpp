// Decimals read as text into exact rationals: no double ever carries an input or a printed number.
#pragma once

#include <string>
#include <string_view>

#include "core/rational.hpp"

namespace stickslip {

// A number as it was typed or printed: its exact value and the weight of its last digit.
struct Decimal {
  std::string text;  // as given
  Rational value;    // exactly what the text says
  Rational unit;     // one unit in the last place: 10^-3 for "7.749"; 1 for "4"

  // A printed value stands for the closed interval [lower, upper] of half a unit in its last place.
  [[nodiscard]] Rational lower() const { return value - unit / 2; }
  [[nodiscard]] Rational upper() const { return value + unit / 2; }
};

// The closed interval [middle - radius, middle + radius]; radius >= 0.
struct Range {
  Rational middle;
  Rational radius = 0;
};

// Reads [+-]digits[.digits][e[+-]digits]. A Unicode minus sign counts as '-'.
// Throws UsageError naming the text when it is not such a number or its exponent exceeds 10000 in size.
[[nodiscard]] Decimal parse_decimal(std::string_view text);

// Reads a decimal as above, or a fraction of two integers such as 1/3. Throws UsageError likewise.
[[nodiscard]] Rational parse_rational(std::string_view text);

// The value of the named parameter: a number as above, or an interval "0.5+-1e-4" ("0.5±1e-4"). Throws
// UsageError naming the parameter and the text.
[[nodiscard]] Range parse_range(const std::string& name, const std::string& text);

// The shortest exact notation: a terminating decimal when there is one of at most 40 digits, else a fraction.
[[nodiscard]] std::string to_string(const Rational& value);

}  // namespace stickslip
