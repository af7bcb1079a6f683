// A chain of links solved from its first node to its last and round again: the deviations d with
//   d+ = M d + g  along the chain,  the last d+ being the first d,
// in balls, in a time that grows with the length of the chain.
//
// A product of many ball matrices is useless when it is formed as it stands, for the balls grow as the norms
// of the factors multiply. So each deviation is written in a frame of its own, d = Q e with Q orthogonal,
// chosen such that M Q = Q+ R with R nearly triangular (Lohner's method): then the balls grow as the
// deviations do.
#pragma once

#include <optional>
#include <vector>

#include "numeric/words/chain.hpp"

namespace stickslip::numeric::words {

// Contains the inverse of each member of A, given a matrix Y near it; nothing when |I - Y A| < 1 in the norm
// of row sums is not proved.
[[nodiscard]] std::optional<model::MatrixX<Ball>> enclosed_inverse(const model::MatrixX<Ball>& A,
                                                                   const model::MatrixX<Ball>& Y);

// An exactly orthogonal matrix; its first k columns nearly span what those of W do, as far as these span
// anything: a landing on the belt collapses a direction.
[[nodiscard]] model::MatrixX<Ball> orthogonal(const Eigen::MatrixXd& W);

struct Sweep {
  // Contain the deviations at all nodes, for all members of the links and of g.
  Nodes deviations;
  // Similar to the derivative of the map round the chain: it has the same eigenvalues.
  model::MatrixX<Ball> return_map;
};

// g: as many as links. Nothing when something is not finite, or 1 may be an eigenvalue of the return map.
[[nodiscard]] std::optional<Sweep> sweep(const std::vector<Link>& links, const Nodes& g);

}  // namespace stickslip::numeric::words
