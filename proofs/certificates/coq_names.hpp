// Names of variables and definitions as Coq takes them.
#pragma once

#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

// The name of a variable, one that Coq takes; different names stay different.
[[nodiscard]] std::string identifier(const std::string& name);
// The name of a definition. The names of variables are others: see hidden_definition.
[[nodiscard]] std::string definition_name(const kernel::Definition& definition);

// The variable of a binder, under a name that nothing in its body has.
[[nodiscard]] kernel::Variable opened_variable(const kernel::Term& term);

// The name of a definition in the term that a variable there, free or bound, has too, so that Coq would take
// one for the other; empty if there is none.
[[nodiscard]] std::string hidden_definition(const kernel::Term& term);

// All definitions applied in the term, and in the bodies of these, each after those it needs.
void collect_definitions(const kernel::Term& term, std::vector<kernel::Definition>& found);

}  // namespace stickslip::proofs::certificates
