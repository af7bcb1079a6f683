// Statements with names for what is long and stands in many of them.
#pragma once

#include <vector>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::certificates {

// The term with each part that is the body of one of these definitions, of whatever arguments, as that
// definition applied. It unfolds to the term.
[[nodiscard]] kernel::Term shortened(const kernel::Term& term,
                                     const std::vector<kernel::Definition>& abbreviations);

}  // namespace stickslip::proofs::certificates
