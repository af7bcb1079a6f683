// Whether a numeric term is zero for all values of its variables, by polynomials (FLINT) in its atoms.
//
// Atoms are π, the entries of variables, of functions applied and of definitions applied (as they stand:
// unfold() first what is to be looked into), and a pair (c, s) with c² + s² = 1 for every phase. Two
// applications are one atom if their arguments are equal by normal form, and functions among these by
// structure. The argument of cos, sin or exp is a rational combination of monomials in the atoms over a
// common denominator; each monomial is a phase, and cos and sin of the sum follow from the addition theorems,
// multiples of π/2 exactly; exp of the sum is a product of powers, of any sign, of one generator per phase,
// which is never zero. That the phases are independent is not used: the answer "zero" is true in any case,
// and a zero may be overlooked.
//
// "Zero" is true wherever none of divisors() is zero: nowhere is anything cancelled that they do not list.
#pragma once

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::kernel {

// Whether each entry is zero, where no divisor is. Throws KernelError for a cos, sin or exp within the
// argument of another, a multiple of a phase beyond 1000, a divisor that is zero itself, and what is not
// numeric.
[[nodiscard]] bool vanishes(const Term& term);

// The formulas d ≠ 0 for everything that the term inverts, as it is written: in the arguments of atoms, of
// cos, sin and exp and in entries never asked for too; of a matrix the determinant. Not for what is a nonzero
// rational multiple of powers of π and of exponentials. Nothing under a binder is looked at, for the normal
// form changes nothing there.
[[nodiscard]] Formulas divisors(const Term& term);

}  // namespace stickslip::proofs::kernel
