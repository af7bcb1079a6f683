// Single edits of printed statements: what a misprint can do to a formula, and the mutants of the tests.
#pragma once

#include <string>
#include <vector>

#include "proofs/term.hpp"

namespace stickslip::proofs {

enum class EditKind {
  sign,      // one term of a sum, or one minus sign, the other way
  factor,    // one factor of a product left out
  index,     // one index changed: H_1 for H_2, omega_1 for omega_2, …; H_11 for h_11
  exchange,  // two entries of a block matrix exchanged
  function,  // cos for sin, sin for cos
  exponent,  // one exponent left out
};

[[nodiscard]] std::string to_string(EditKind kind);

struct Edit {
  EditKind kind = EditKind::sign;
  std::string what;     // "sign of H2(t)*H3(t)"
  Statement statement;  // with that edit made, and no other
};

// Every single edit that leaves a formula with meaning (shapes fit), in the order in which the statement is
// read.
[[nodiscard]] std::vector<Edit> edits(const Statement& statement);

}  // namespace stickslip::proofs
