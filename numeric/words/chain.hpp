// A periodic motion through any word as a chain of events: the closing conditions by multiple shooting, and
// their linearisation along the chain.
//
// A node is an event: its time t and the state without x_j', the velocity of the mass that rubs, which is
// known there. Between two nodes the motion is one phase; the conditions on nodes u, u+ at both ends of a
// phase of duration h = t+ - t are
//   the state of u+ minus that of the flow at h, without x_j'
//   g(flow at h) = 0, the event: x_j' is the belt's velocity, or r is a bound of the friction at rest
// and the chain closes when the node after the last is the first one n periods of the load later.
//
// Their derivative couples neighbours only. With Z' the velocity of the flow at the beginning and at the end,
// and H its derivative, a deviation (dt, dz) of a node arrives at t+ as w = H (dz - Z'(0) dt), and the next
// event takes place dt+ later,
//   D w + g'(h) dt+ = 0,   D the gradient of g by the state,
// there with the deviation (dt+, w + Z'(h) dt+).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/ball.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::words {

// (t, the state at an event without x_j').
using Node = model::VectorX<Ball>;
using Nodes = std::vector<Node>;

// Exactly the middles of the balls.
[[nodiscard]] Node midpoint(const Node& u);
[[nodiscard]] Nodes midpoints(const Nodes& nodes);

// The linearisation of a phase: a deviation d of its first node and a change F of its conditions go with
//   d+ = M d + response(F).
struct Link {
  model::MatrixX<Ball> M;
  Node end_velocity;  // (1, the velocity of the flow at its end, without x_j'')
  Ball rate;          // g': how fast the event is passed
  [[nodiscard]] Node response(const Node& F) const;
};

// A question at the working precision of the moment.
class Chain {
 public:
  virtual ~Chain() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  // The conditions of phase i between the nodes, the event's last.
  [[nodiscard]] virtual Node conditions(const Nodes& nodes, std::size_t i) const = 0;
  // The link of phase i for all nodes in the balls. Its entries are not finite where the event at its end may
  // not be transversal.
  [[nodiscard]] virtual Link link(const Nodes& nodes, std::size_t i) const = 0;
};

// Makes the chain at the working precision.
using ChainAt = std::function<std::unique_ptr<Chain>()>;

}  // namespace stickslip::numeric::words
