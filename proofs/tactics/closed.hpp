// Formulas without variables: whether they hold, as theorems. Inequalities are decided in balls, equations by
// normal form.
#pragma once

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::tactics {

// The formula, made of relations between numbers and matrices by and, or, not. Throws KernelError where it is
// false or not decided: it has a variable or a quantifier, two numbers are too close to tell, or are equal
// and no normal form says so.
[[nodiscard]] Theorem certainly(const Formula& formula);
// Its negation.
[[nodiscard]] Theorem certainly_not(const Formula& formula);
// The theorem less those of its hypotheses that are of this kind and hold. Throws KernelError where one of
// the hypotheses is not decided.
[[nodiscard]] Theorem without_hypotheses(Theorem theorem);

}  // namespace stickslip::proofs::tactics
