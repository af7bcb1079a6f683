// What is false, as a theorem of the kernel: there are values with which all that is assumed holds, and the
// conclusion does not.
#pragma once

#include <optional>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

class Derivation;
class Prover;

// Values of symbols: rational ones, and those that are given in terms of others, "symbol = value". A motion
// that is assumed to obey a differential equation is found: of the oscillator the flow from the state Z(a) in
// which it is said to begin, or from rest; of another paper one of the closed forms "Z(t) = expression" that
// its claims state, with Z(a) in it as it is assumed to be, or 0. Where it is assumed of a second phase it
// obeys this as it is, or is joined of a flow for each.
struct Scene {
  std::vector<Coordinate> point = {};
  std::vector<symbols::Statement> values = {};
  Rational state = 1;  // of which nothing is said: z10, zdot10, …
  std::vector<symbols::Statement> closed_forms = {};
};

// ⊢ there are omega1, omega2, …, perhaps X, in the parameters' domain, with all of `holding` and none of
// `failing`. The domain is that of the parameters that occur. Equations that hold for every point come by
// normal form, all else is decided at the point (tactics/closed.hpp). Throws KernelError where that does not
// work: then nothing is known. Throws symbols::NoValue for what the kernel cannot say.
[[nodiscard]] kernel::Theorem refutation(Prover& prover, const Scene& scene,
                                         const std::vector<symbols::Statement>& holding,
                                         const std::vector<symbols::Statement>& failing);

// Both sides, in balls, of an entry in which they certainly differ, or of the first.
[[nodiscard]] Witness witness_of(const symbols::Statement& statement, const Scene& scene);

// Where the outcome is undecided: refuted, if it is a theorem that there are values with which all that the
// claim assumes holds and what it prints does not; they are sought where an equation fails that the outcome
// doubts, or what is printed.
void look_for_witness(Outcome& outcome, Prover& prover, const Claim& claim);

// ⊢ there are values in the domain with which all that the claim assumes holds, and no hypothesis vanishes;
// nothing where none was found.
[[nodiscard]] std::optional<kernel::Theorem> obeying_values(Prover& prover, const Claim& claim,
                                                            const std::vector<Hypothesis>& hypotheses = {});
// The same, at points drawn at random (points.cpp): longer work, for what speaks of numbers alone.
[[nodiscard]] std::optional<kernel::Theorem> obeying_point(Prover& prover, const Claim& claim,
                                                           const std::vector<Hypothesis>& hypotheses = {});

// Where to look for witnesses: points in the parameters' domain at which statements hold, or fail, nearly.
// Floats propose, the refutation decides (points.cpp).

// What a claim assumes; and the claim that assumes the hypotheses, too.
[[nodiscard]] std::vector<symbols::Statement> assumed_statements(const Claim& claim);
[[nodiscard]] Claim with_hypotheses(const Claim& claim, const std::vector<Hypothesis>& hypotheses);

// The statement refuted at such a point, perhaps one where an equation more holds, or one at which `doubted`
// fails in its place.
[[nodiscard]] std::optional<Outcome> refuted_at_point(Prover& prover, const Claim& claim,
                                                      const symbols::Statement& printed,
                                                      const std::optional<symbols::Statement>& where = {},
                                                      const std::optional<symbols::Statement>& doubted = {});

// Whether there is such a point at which what the claim assumes holds and the statement fails, in floating
// point.
[[nodiscard]] bool seems_to_fail(Prover& prover, const Claim& claim, const symbols::Statement& statement);

// Neither of vectors or matrices, nor of functions.
[[nodiscard]] bool is_equation_of_numbers(const kernel::Formula& formula);

// The assumed equations between numbers, one after the other solved for a letter in which it is linear:
// letter = value, the letters before put in. A letter is a variable, or a cosine and the like if
// `any_letter`. `choice` counts the ways to choose the letters; nothing where there are no more. Those that
// can't be solved are left out.
[[nodiscard]] std::optional<std::vector<kernel::Theorem>> solved_in_turn(Derivation& derivation,
                                                                         std::size_t choice, bool any_letter);

}  // namespace stickslip::proofs::methods
