// A periodic motion through any word as a chain of events: the closing conditions by multiple shooting, and
// their linearisation along the chain.
//
// A node is an event, x2' = V at the time t: u = (t, z1, z2, z1'). The load is cos omega t, so a node knows
// its phase and the phase of the load is no unknown. Between two nodes the motion is one phase of closed form
// (5), (8), (10); the conditions on nodes u, u+ at both ends of a phase of duration h = t+ - t are
//   F1, F2, F3   z1+, z2+, z1'+ minus z1, z2, z1' of the flow at h
//   F4           z2'(h) - V where a slip or an overshoot ends; r of u+ minus ur where a stick ends before a
//                slip, plus ur before an overshoot
// and the chain closes when the node after the last is the first one n periods of the load later.
//
// Their derivative couples neighbours only. With Z' the velocity of the flow at the beginning and at the end,
// and H (or Gamma) its derivative, a deviation (dt, dz) of a node arrives at t+ as w = H (dz - Z'(0) dt), and
// the next event takes place dt+ later,
//   slip, overshoot   w4 + z2''(h) dt+ = 0
//   stick             chi (w2 - w1) + r'(h) dt+ = 0
// there with the deviation (dt+, w + Z'(h) dt+).
#pragma once

#include <vector>

#include "core/rational.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::words {

// (t, z1, z2, z1') at an event.
using Node = model::Vector4<Ball>;
using Nodes = std::vector<Node>;

// What closed chains are asked for, exactly.
struct ChainQuestion {
  motion::ExactParameters data;
  Rational ur;
  std::vector<motion::PhaseKind> phases;  // phase i begins at node i
  long periods = 1;                       // n
};

// The linearisation of a phase: a deviation d of its first node and a change F of its conditions go with
//   d+ = M d + response(F).
struct Link {
  model::Matrix4<Ball> M;
  Node end_velocity;  // (1, z1', z2', z1'') of the flow at its end
  Ball rate;          // z2'' or r' at the end: how fast the event is passed
  Ball pull;          // chi for a stick, else 0
  [[nodiscard]] Node response(const Node& F) const;
};

// The question at the working precision of the moment.
class Chain {
 public:
  explicit Chain(const ChainQuestion& question);

  [[nodiscard]] std::size_t size() const { return phases_.size(); }
  [[nodiscard]] const model::Oscillator<Ball>& oscillator() const { return oscillator_; }
  [[nodiscard]] const Ball& ur() const { return ur_; }

  // F of phase i between the nodes.
  [[nodiscard]] Node conditions(const Nodes& nodes, std::size_t i) const;
  // The link of phase i for all nodes in the balls. Its entries are not finite where the event at its end may
  // not be transversal.
  [[nodiscard]] Link link(const Nodes& nodes, std::size_t i) const;
  // The motion that starts at node 0; phase i is that of node i.
  [[nodiscard]] motion::Motion motion(const Nodes& nodes) const;
  // The node after node i; after the last the first, n periods later.
  [[nodiscard]] Node next(const Nodes& nodes, std::size_t i) const;

 private:
  struct Flow;
  [[nodiscard]] Flow flow(const Node& from, const Ball& until, motion::PhaseKind kind) const;
  [[nodiscard]] Ball acceleration(motion::PhaseKind kind, const model::Vector4<Ball>& Z,
                                  const Ball& psi) const;

  std::vector<motion::PhaseKind> phases_;
  model::Oscillator<Ball> oscillator_;
  Ball ur_;
  Ball turn_;  // n Theta
};

}  // namespace stickslip::numeric::words
