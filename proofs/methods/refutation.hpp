// What is false, as a theorem of the kernel: there are values with which all that is assumed holds, and the
// conclusion does not.
#pragma once

#include <optional>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

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
// The same, at points drawn at random (points.hpp): longer work, for what speaks of numbers alone.
[[nodiscard]] std::optional<kernel::Theorem> obeying_point(Prover& prover, const Claim& claim,
                                                           const std::vector<Hypothesis>& hypotheses = {});

}  // namespace stickslip::proofs::methods
