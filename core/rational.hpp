// Exact rational numbers: how every input and every printed number is held.
#pragma once

#include <gmpxx.h>

namespace stickslip {

// Always in lowest terms with a positive denominator; a constructor from two parts does NOT reduce them: call
// canonicalize() after it unless they have no common factor.
using Rational = mpq_class;

}  // namespace stickslip
