// Closed chains of events: existence and uniqueness near a guess.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/verdict.hpp"
#include "numeric/machines/orbits/chain.hpp"
#include "numeric/motion/eigenvalues.hpp"

namespace stickslip::numeric::machines {

// A chain of links solved from its first node to its last and round again: the deviations d with
//   d+ = M d + g  along the chain,  the last d+ being the first d,
// in balls, in a time that grows with the length of the chain.
//
// A product of many ball matrices is useless when it is formed as it stands, for the balls grow as the norms
// of the factors multiply. So each deviation is written in a frame of its own, d = Q e with Q orthogonal in
// units that balance the links, chosen such that M Q = Q+ R with R nearly triangular (Lohner's method): then
// the balls grow as the deviations do.

// Contains the inverse of each member of A, given a matrix Y near it; nothing when |I - Y A| < 1 in the norm
// of row sums is not proved.
[[nodiscard]] std::optional<model::MatrixX<Ball>> enclosed_inverse(const model::MatrixX<Ball>& A,
                                                                   const model::MatrixX<Ball>& Y);

// An exactly orthogonal matrix; its first k columns nearly span what those of W do, as far as these span
// anything: a landing on the belt collapses a direction.
[[nodiscard]] model::MatrixX<Ball> orthogonal(const Eigen::MatrixXd& W);

class LinearChain {
 public:
  // Nothing when a link is not finite, or 1 may be an eigenvalue of the return map.
  [[nodiscard]] static std::optional<LinearChain> of(std::vector<Link> links);
  // Contain the deviations at all nodes, for all members of the links and of g, of which there are as many.
  [[nodiscard]] Nodes deviations(const Nodes& g) const;
  // Similar to the derivative of the map round the chain: it has the same eigenvalues.
  [[nodiscard]] const model::MatrixX<Ball>& return_map() const { return P_.back(); }

 private:
  LinearChain() = default;

  std::vector<long> units_;  // powers of two, as exponents, in which the links are balanced
  std::vector<model::MatrixX<Ball>> Q_, R_, P_;  // e_i = P_i e_0 + what g adds
  model::MatrixX<Ball> inverse_;                 // near that of 1 - P at the end
  Ball share_;                                   // so far off, in parts of a solution
};

// Existence and uniqueness of a closed chain near a guess, by the interval Newton operator.
//
// Formulation: the conditions F(u) = 0 of chain.hpp. Approximation: Newton's method with
// the linear algebra above, at as many bits as are asked for. Bounds: N(X) = m - J(X)⁻¹ F(m) over a
// box X with the midpoint m. Conclusion: if N(X) lies inside X, exactly one zero of F lies in X, and it lies
// in N(X).

struct ChainProof {
  Verdict verdict;  // of "exactly one closed chain has its nodes in `unique`"; what follows needs it proved
  long bits = 0;    // that it was proved with
  Nodes nodes;      // contain its nodes
  Nodes unique;
  motion::SquareMatrix return_map;  // has the chain's multipliers as eigenvalues
  NodesInData in_data = {};         // the nodes of many machines
};

// Newton's test, as it stands, for the box about m whose radii are 2^exponent in units of 1 + |m| for each
// component: exact nodes m, no search. Undecided unless passed.
[[nodiscard]] ChainProof newton_test(const MachineQuestion& question, const Nodes& m, long exponent);

// Tries precisions from `bits` to `most_bits`, four times as many after each failure. The guess may be as
// rough as Newton's method allows. Undecided when none does, with the reason.
[[nodiscard]] ChainProof prove_chain(const MachineQuestion& question, const Nodes& guess, long bits,
                                     long most_bits);

// A closed chain that is proved for the machine at these s.
struct Known {
  std::vector<Rational> s;
  ChainProof proof;
};

// For all machines of a chain over data a polynomial of nodes near their closed chains, in floats, from that
// of the machine in the middle, whose chain is given, too; nothing where there is none.
[[nodiscard]] std::optional<NodesInData> approximate_chains(const Chain& chain, const Chain& in_middle,
                                                            const Nodes& middle);

// For these machines Newton's test about such a polynomial, all at once. Proved: for
// each machine exactly one closed chain has its nodes in a box about the polynomial there; these depend
// continuously on the data, and the known ones are among them; the nodes contain all, and the return map that
// of each.
[[nodiscard]] ChainProof prove_chains(const Chain& chain, const NodesInData& nodes,
                                      const std::vector<Known>& known);

// Newton's method in floats at the working precision; nothing where it leads nowhere.
[[nodiscard]] std::optional<Nodes> approximate_chain(const MachineQuestion& question, const Nodes& guess);

// How many times a shorter closed chain the proved one is; undecided where that is not known. With a load the
// shorter one closes after whole periods of it.
[[nodiscard]] std::pair<long, Verdict> repetition(const MachineQuestion& question, const ChainProof& proof);

}  // namespace stickslip::numeric::machines
