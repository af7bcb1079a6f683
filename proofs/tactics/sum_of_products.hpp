// Inequalities as sums of products.
#pragma once

#include <vector>

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// a < b or a ≤ b, where b - a is a sum of products of inequalities that are known, of squares of monomials
// and of sums and differences of two, and of multiples of equations that are known: looked for by linear
// programming, among products of bounded degree, with cos(u)² + sin(u)² = 1. What is known and divides by
// variables is of no use. Takes the sizes of the programs from the work. Throws KernelError where it finds
// nothing.
[[nodiscard]] Theorem sum_of_products(const Formula& inequality, const std::vector<Theorem>& known,
                                      long& work);

}  // namespace stickslip::proofs::tactics
