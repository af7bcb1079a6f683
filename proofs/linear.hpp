// Methods of proof for coefficients of linear equations.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods.hpp"

namespace stickslip::proofs {

// The printed equation "name = value": value is what stands in front of `unknown` in the expression, a scalar
// that is linear in the unknowns; with unknown = 1, what is left when all of them are zero.
[[nodiscard]] Proof by_coefficient(const Term& name, const Term& expression, std::vector<Term> unknowns,
                                   const Term& unknown);

struct Named {
  Term name;
  GiNaC::ex value;
};

// The printed equations are "name = value", in this order, with the values that the model's own formulas
// give.
[[nodiscard]] Proof by_formulas(std::function<std::vector<Named>()> values);

}  // namespace stickslip::proofs
