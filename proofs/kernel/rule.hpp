// What the rules share; for their files only.
#pragma once

#include <optional>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::kernel {

inline void require(bool holds, const std::string& message) {
  if (!holds) {
    throw KernelError(message);
  }
}

[[nodiscard]] Formulas hypotheses_of(const std::vector<Theorem>& premises);

// The two sides of a theorem whose conclusion is such a relation.
[[nodiscard]] inline std::pair<Term, Term> sides(const Theorem& theorem, Kind relation) {
  require(theorem.conclusion().kind() == relation, "a premise is not the relation that the rule needs");
  return {theorem.conclusion().parts()[0], theorem.conclusion().parts()[1]};
}

}  // namespace stickslip::proofs::kernel
