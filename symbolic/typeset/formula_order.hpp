// The order in which the parts of a formula are written (formula.hpp).
#pragma once

#include <compare>

#include "symbolic/typeset/formula.hpp"

namespace stickslip::symbolic::typeset {

// π, symbols by compare_names(), functions by name, then arguments; cos, sin, tan by argument, then name.
[[nodiscard]] std::strong_ordering compare(const Atom& a, const Atom& b);

// Fewer terms first, then term by term, signs last.
[[nodiscard]] std::strong_ordering compare(const Sum& a, const Sum& b);

// π, symbols, functions; sums without cos, sin, tan; sums with them; cos, sin, tan. Exponents are not looked
// at.
[[nodiscard]] std::strong_ordering compare_bases(const Power& a, const Power& b);

}  // namespace stickslip::symbolic::typeset
