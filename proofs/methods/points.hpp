// Where to look for witnesses: points in the parameters' domain at which statements hold, or fail, nearly.
// Floats propose; refutation.hpp decides.
#pragma once

#include <optional>
#include <vector>

#include "proofs/methods/derivation.hpp"
#include "proofs/methods/refutation.hpp"

namespace stickslip::proofs::methods {

// Up to `most` scenes, drawn at random, the same on every run, at which all that the claim assumes of numbers
// holds nearly and `failing`, if it is given, does not. Assumed equations between numbers are solved for one
// of their symbols each where they are linear in one. None where `failing` speaks of motions.
[[nodiscard]] std::vector<Scene> scenes(Prover& prover, const Claim& claim,
                                        const std::optional<symbols::Statement>& failing, std::size_t most);

// What a claim assumes; and the claim that assumes the hypotheses, too.
[[nodiscard]] std::vector<symbols::Statement> assumed_statements(const Claim& claim);
[[nodiscard]] Claim with_hypotheses(const Claim& claim, const std::vector<Hypothesis>& hypotheses);

// The statement refuted at such a point, perhaps one where an equation more holds, or one at which `doubted`
// fails in its place.
[[nodiscard]] std::optional<Outcome> refuted_at_point(Prover& prover, const Claim& claim,
                                                      const symbols::Statement& printed,
                                                      const std::optional<symbols::Statement>& where = {},
                                                      const std::optional<symbols::Statement>& doubted = {});

// Neither of vectors or matrices, nor of functions.
[[nodiscard]] bool is_equation_of_numbers(const kernel::Formula& formula);

// The assumed equations between numbers, one after the other solved for a letter in which it is linear:
// letter = value, the letters before put in. A letter is a variable, or a cosine and the like if
// `any_letter`. `choice` counts the ways to choose the letters; nothing where there are no more. Those that
// can't be solved are left out.
[[nodiscard]] std::optional<std::vector<kernel::Theorem>> solved_in_turn(Derivation& derivation,
                                                                         std::size_t choice, bool any_letter);

}  // namespace stickslip::proofs::methods
