// Terms and formulas of the kernel as Coq has them (prelude/).
//
// One constructor is always the same Coq symbol, whatever stands inside: then what the kernel makes by
// putting terms in for variables is, letter by letter, what Coq makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

// Names of variables and definitions as Coq takes them.

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

// "R", "Z", "Mat 2 2", "R -> Mat 4 1".
[[nodiscard]] std::string coq_type(const kernel::Type& type);
// Any value of that type.
[[nodiscard]] std::string any_value(const kernel::Type& type);

// A term or formula, in parentheses where it needs them as an argument.
[[nodiscard]] std::string coq(const kernel::Term& term);
// The same with as few parentheses as Coq needs where nothing follows, or only "->".
[[nodiscard]] std::string coq_statement(const kernel::Term& term);
[[nodiscard]] std::string coq_premise(const kernel::Term& term);

// What coq_statement reads as, in lines: what there is on the first, then a line for each part of a
// conjunction.
[[nodiscard]] std::string coq_lines(const kernel::Term& formula);

// "(omega1 tau : R) (X : R -> Mat 4 1)": in the order given.
[[nodiscard]] std::string binders(const std::vector<kernel::Variable>& variables);

// "Definition H1 (t omega1 omega2 : R) : Mat 2 2 := …."
[[nodiscard]] std::string coq_definition(const kernel::Definition& definition);

// Identities of the kernel, and words about them for Coq.

// a + (-1) b, also of numbers: as rdiffer and mdiffer of the prelude have it.
[[nodiscard]] kernel::Term difference(const kernel::Term& a, const kernel::Term& b);

// left = right by normal form, with these definitions looked into; nothing where the kernel does not see it.
[[nodiscard]] std::optional<kernel::Theorem> identity(const kernel::Term& left, const kernel::Term& right,
                                                      const kernel::Definitions& unfolded = {});

// In Coq, the zero of a combination of that type; whole numbers are written as numbers.
[[nodiscard]] std::string nothing(const kernel::Type& type);

// "H K chi": their names in Coq.
[[nodiscard]] std::string names_of(const kernel::Definitions& definitions);
// "cbv beta delta [H K chi]" between these; nothing of none.
[[nodiscard]] std::string opening(const std::string& before, const kernel::Definitions& definitions,
                                  const std::string& after);

}  // namespace stickslip::proofs::certificates
