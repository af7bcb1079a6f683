// What terms and rules are made with; for their files only.
#pragma once

#include <optional>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::kernel {

inline void require(bool holds, const char * message) {
  if (!holds) {
    throw KernelError(message);
  }
}
inline void require(bool holds, const std::string& message) {
  require(holds, message.c_str());
}

[[nodiscard]] inline bool is_binder(Kind kind) {
  return kind == Kind::lambda || kind == Kind::for_all || kind == Kind::exists || kind == Kind::finite;
}

// The same node with other parts.
[[nodiscard]] Term rebuilt(const Term& term, std::vector<Term> parts);
// The body with `argument` for the index 0, and the other loose indices one lower.
[[nodiscard]] Term instantiated(const Term& body, const Term& argument);
// All loose indices moved by that many.
[[nodiscard]] Term shifted(const Term& term, long by, long above = 0);
// The variable as the index 0 of a binder to be put around.
[[nodiscard]] Term abstracted(const Term& body, const Variable& variable);

// The derivative of a term without functions of time in a number x.
[[nodiscard]] Term partial_derivative(const Term& term, const Variable& x);

// The two sides of a theorem whose conclusion is such a relation.
[[nodiscard]] inline std::pair<Term, Term> sides(const Theorem& theorem, Kind relation) {
  require(theorem.conclusion().kind() == relation, "a premise is not the relation that the rule needs");
  return {theorem.conclusion().parts()[0], theorem.conclusion().parts()[1]};
}

}  // namespace stickslip::proofs::kernel
