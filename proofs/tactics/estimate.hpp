// Terms in floating point at a point that is made up: what is not even nearly zero there need not be tried.
#pragma once

#include <map>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::tactics {

// Whether the sum of the terms, of one shape, is nearly zero once these definitions are opened, beside the
// largest of them. Variables, and applications of functions and of all other definitions, have values that
// depend on nothing but their name and arguments. True proves nothing; false only advises against a proof.
[[nodiscard]] bool seems_zero(const std::vector<kernel::Term>& parts, const kernel::Definitions& unfolded);

// A number nearly, all definitions opened, where these variables have these values, and all others made up.
using Point = std::map<kernel::Variable, Rational, kernel::Before>;
[[nodiscard]] long double estimated(const kernel::Term& number, const Point& values);

}  // namespace stickslip::proofs::tactics
