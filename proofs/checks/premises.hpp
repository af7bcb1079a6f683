// What a claim rests on, sorted by what it is good for when the claim is evaluated.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::checks {

// What the claim assumes, and what the premises of the outcome's proof say that are no identities.
struct Premises {
  std::map<std::string, symbols::Term> motions;  // "Z(t) = ...": the value at t of Z, X, ...
  symbols::Replacements values;                  // "a_1 = ...", of a name that has no other meaning
  std::vector<symbols::Statement> equations, inequalities;  // in what has values, the motions put in
  std::vector<symbols::Statement> left_out;                 // what has none, such as "Z(tau) = Z_B"
  std::vector<methods::Hypothesis> hypotheses;
  bool consistent = true;  // no motion has two meanings

  // The statement with the motions put in.
  [[nodiscard]] symbols::Statement with_motions(const symbols::Statement& statement) const;
  // The names of the symbols with which the value of the term, all values put in, changes.
  [[nodiscard]] std::set<std::string> reached(const symbols::Term& term) const;
  // The premises with further values; nothing where a name has one already, or would be given by itself.
  [[nodiscard]] std::optional<Premises> with(const symbols::Replacements& further) const;
};

[[nodiscard]] Premises premises_of(methods::Prover& prover, const methods::Claim& claim,
                                   const methods::Outcome& outcome);

// Whether it is a scalar to which neither the table of symbols nor the model gives a value.
[[nodiscard]] bool stands_for_itself(const symbols::Term& term);

// The scalars that equations are solved for: states, the constant coefficients d_i of (21), accelerations,
// belt speed and friction.
[[nodiscard]] const std::vector<std::string>& solved_for();

}  // namespace stickslip::proofs::checks
