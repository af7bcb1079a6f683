// What a claim rests on, sorted by what it is good for when the claim is evaluated.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/prover.hpp"

namespace stickslip::proofs {

// What the claim assumes, and what the premises of the outcome's proof say that are no identities.
struct Premises {
  std::map<std::string, Term> motions;             // "Z(t) = ...": the value at t of Z, X, ...
  Replacements values;                             // "a_1 = ...", of a name that has no other meaning
  std::vector<Statement> equations, inequalities;  // in what has values, the motions put in
  std::vector<Statement> left_out;                 // what has none, such as "Z(tau) = Z_B"
  std::vector<Hypothesis> hypotheses;
  bool consistent = true;  // no motion has two meanings

  // The statement with the motions put in.
  [[nodiscard]] Statement with_motions(const Statement& statement) const;
  // The premises with further values; nothing where a name has one already, or would be given by itself.
  [[nodiscard]] std::optional<Premises> with(const Replacements& further) const;
};

[[nodiscard]] Premises premises_of(Prover& prover, const Claim& claim, const Outcome& outcome);

// The scalars that equations are solved for: states, the constant coefficients d_i of (21), accelerations,
// belt speed and friction.
[[nodiscard]] const std::vector<std::string>& solved_for();

}  // namespace stickslip::proofs
