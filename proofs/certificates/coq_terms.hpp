// Terms and formulas of the kernel as Coq has them (prelude/).
//
// One constructor is always the same Coq symbol, whatever stands inside: then what the kernel makes by
// putting terms in for variables is, letter by letter, what Coq makes.
#pragma once

#include <string>
#include <vector>

#include "proofs/certificates/coq_names.hpp"

namespace stickslip::proofs::certificates {

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
}  // namespace stickslip::proofs::certificates
