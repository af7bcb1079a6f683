// Existence and uniqueness of a closed chain near a guess, by the interval Newton operator.
//
// Formulation: the conditions F(u) = 0 of chain.hpp, four for each node. Approximation: Newton's method with
// the linear algebra of sweep.hpp, at as many bits as are asked for. Bounds: N(X) = m - J(X)⁻¹ F(m) over a
// box X with the midpoint m. Conclusion: if N(X) lies inside X, exactly one zero of F lies in X, and it lies
// in N(X).
#pragma once

#include "core/verdict.hpp"
#include "numeric/motion/eigenvalues.hpp"
#include "numeric/words/chain.hpp"

namespace stickslip::numeric::words {

struct ChainProof {
  Verdict verdict;  // of "exactly one closed chain has its nodes in `unique`"; what follows needs it proved
  long bits = 0;    // that it was proved with
  Nodes nodes;      // contain its nodes
  Nodes unique;
  motion::SquareMatrix return_map;  // has the chain's multipliers as eigenvalues
};

// Newton's test, as it stands, for the box about m whose radii are 2^exponent in units of 1 + |m| for each
// component: exact nodes m, no search. Undecided unless passed.
[[nodiscard]] ChainProof newton_test(const ChainAt& chain_at, const Nodes& m, long exponent);

// Tries precisions from `bits` to `most_bits`, four times as many after each failure. The guess may be as
// rough as Newton's method allows. Undecided when none does, with the reason.
[[nodiscard]] ChainProof prove_chain(const ChainAt& chain_at, const Nodes& guess, long bits, long most_bits);

}  // namespace stickslip::numeric::words
