// Single edits of printed statements: what a misprint can do to a formula, and the mutants of the tests.
#pragma once

#include <string>
#include <vector>

#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::checks {

enum class EditKind {
  sign,      // one term of a sum, or one minus sign, the other way
  factor,    // one factor of a product left out
  index,     // one index changed: H_1 for H_2, omega_1 for omega_2, …; H_11 for h_11
  exchange,  // two entries of a block matrix exchanged
  function,  // cos for sin, sin for cos
  exponent,  // one exponent left out
  letter,    // one letter for another of its kind: H for Gamma, Z_B for Z_0, Q for d_0
  prime,     // one derivative left out: H_2 for H_2', z_10 for z_10'
  period,    // one duration halved: T/2 for T
};

[[nodiscard]] std::string to_string(EditKind kind);

struct Edit {
  EditKind kind = EditKind::sign;
  std::string what;              // "sign of H2(t)*H3(t)"
  symbols::Statement statement;  // with that edit made, and no other
};

// Every single edit that leaves a formula with meaning (shapes fit), in the order in which the statement is
// read.
[[nodiscard]] std::vector<Edit> edits(const symbols::Statement& statement);

// For each kind of edit and each place where it can be made, the statement written another way that says the
// same: the other way to write a sign, a factor, …
[[nodiscard]] std::vector<Edit> rewritings(const symbols::Statement& statement);

}  // namespace stickslip::proofs::checks
