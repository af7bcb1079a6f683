// Methods of proof for coefficients of linear equations.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "proofs/methods/methods.hpp"

namespace stickslip::proofs::methods {

// What stands in front of an unknown in an expression, a scalar that is linear in the unknowns; with unknown
// = 1, what is left when all of them are zero.
struct Coefficient {
  symbols::Term expression;
  symbols::Term unknown;
};

// The printed equations are "name = value": value is the coefficient that `named` knows by this name.
[[nodiscard]] Proof by_coefficient(std::function<std::optional<Coefficient>(const symbols::Term& name)> named,
                                   std::vector<symbols::Term> unknowns);

struct Named {
  symbols::Term name;
  GiNaC::ex value;
};

// The printed equations are "name = value", one for each of these, with the values that the model's own
// formulas give.
[[nodiscard]] Proof by_formulas(std::function<std::vector<Named>()> values);

}  // namespace stickslip::proofs::methods
