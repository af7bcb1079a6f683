// Equations and inequalities between numbers from others, for all values of their variables. No definition is
// opened. Throw KernelError where nothing is found: that says nothing.
#pragma once

#include <vector>

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// a < b or a ≤ b from inequalities and equations that are known: as a sum of products (sum_of_products.hpp),
// where -1 ≤ sin u, cos u ≤ 1, and 0 < sin u (or cos u) where u is known to lie so; else along a variable
// that stands in a sine, cosine or exponential, from an end where it is known, by the mean value theorem; of
// variables that lie between numbers in balls, on pieces of that range; of one variable also on parts of its
// range (cuts.hpp); else since its opposite, beside what is known, gives 0 < 0 as such a sum.
[[nodiscard]] Theorem inequality(const Formula& inequality, const std::vector<Theorem>& known);

// a = b, where b - a is a factor of what is known to be zero, and the inequalities that are known say that
// the other factors are not; or from both inequalities, or from a square.
[[nodiscard]] Theorem equation(const Formula& equation, const std::vector<Theorem>& known);

}  // namespace stickslip::proofs::tactics
