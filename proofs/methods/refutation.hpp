// What is false, as a theorem of the kernel: there are values with which all that is assumed holds, and the
// conclusion does not.
#pragma once

#include <optional>
#include <vector>

#include "core/verdict.hpp"
#include "proofs/kernel/theorem.hpp"
#include "proofs/symbols/term.hpp"

namespace stickslip::proofs::methods {

class Prover;

// Values of symbols: rational ones, and those that are given in terms of others, "symbol = value". A motion X
// that is assumed to obey a linear differential equation is found: the flow from the state Z(a) in which it
// is said to begin, or from rest.
struct Scene {
  std::vector<Coordinate> point = {};
  std::vector<symbols::Statement> values = {};
  Rational state = 1;  // of which nothing is said: z10, zdot10, …
};

// ⊢ there are omega1, omega2, …, perhaps X, in the parameters' domain, with all of `holding` and none of
// `failing`. The domain is that of the parameters that occur. Equations that hold for every point come by
// normal form, all else is decided at the point (tactics/closed.hpp). Throws KernelError where that does not
// work: then nothing is known. Throws symbols::NoValue for what the kernel cannot say.
[[nodiscard]] kernel::Theorem refutation(Prover& prover, const Scene& scene,
                                         const std::vector<symbols::Statement>& holding,
                                         const std::vector<symbols::Statement>& failing);

struct Claim;
// ⊢ there are values in the domain with which all that the claim assumes holds; nothing where none was found.
[[nodiscard]] std::optional<kernel::Theorem> obeying_values(Prover& prover, const Claim& claim);

}  // namespace stickslip::proofs::methods
