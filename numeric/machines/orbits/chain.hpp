// A periodic motion of a machine through given pieces as a chain of events: the closing conditions by
// multiple shooting, and their linearisation along the chain.
//
// A node is an event: its time t and the state (x, x') without x_j', the velocity of the mass that rubs, 2 n
// numbers for n masses. x_j' is the belt's velocity where a phase of another kind begins, and the one at
// which a piece of the friction law ends where another piece of it does; these are events, too. With a load t
// is the time, and theta = omega t. Without, each shift in time of a motion is a motion: there t is the
// duration of the phase that ends at the node, and the node before does not depend on it. Between two nodes
// the motion is one phase; the conditions on nodes u, u+ at both ends of a phase of duration h are
//   the state of u+ minus that of the flow at h, without x_j'
//   g(flow at h) = 0, the event: x_j' is the velocity there, or r is a bound of the friction at rest
// and the chain closes when the node after the last is the first one n periods of the load later.
//
// Their derivative couples neighbours only. With X' the velocity of the flow at the beginning and at the end,
// and H its derivative, a deviation (dt, dX) of a node arrives at t+ as w = H (dX - X'(0) dt), and the next
// event takes place dt+ later,
//   D w + g'(h) dt+ = 0,   D the gradient of g by the state,
// there with the deviation (dt+, w + X'(h) dt+).
#pragma once

#include <optional>
#include <vector>

#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/linear_phases.hpp"
#include "numeric/machines/phases/passage.hpp"

namespace stickslip::numeric::machines {

// (t, the state at an event without x_j').
using Node = Vector;
using Nodes = std::vector<Node>;

// As functions of data, columns.
using NodesInData = std::vector<InData<Matrix>>;

// Exactly the middles of the balls.
[[nodiscard]] Nodes midpoints(const Nodes& nodes);

// The linearisation of a phase: a deviation d of its first node and a change F of its conditions go with
//   d+ = M d + response(F).
struct Link {
  InData<Matrix> M;   // of one machine a constant
  Node end_velocity;  // (1, the velocity of the flow at its end, without x_j'')
  Ball rate;          // g': how fast the event is passed
  Node conditions;    // of the phase between the nodes
  [[nodiscard]] Node response(const Node& F) const;
};

struct MachineQuestion {
  Machine machine;
  std::vector<Piece> pieces;  // piece i begins at node i; neighbours differ
  long periods = 1;           // of the load, if there is one
  // If there are any all machines are meant whose numbers are these functions of data; `machine` is that in
  // the middle.
  std::optional<OscillatorInData> machines = {};
};

// At the working precision at which it is made. It keeps what it has computed.
class Chain {
 public:
  explicit Chain(const MachineQuestion& question);

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  // The conditions of phase i between the nodes, the event's last.
  [[nodiscard]] Node conditions(const Nodes& nodes, std::size_t i) const;
  // The link of phase i for all nodes in the balls. Its entries are not finite where the event at its end may
  // not be transversal.
  [[nodiscard]] Link link(const Nodes& nodes, std::size_t i) const;

  // For all machines the same as functions of the data.
  [[nodiscard]] InData<Matrix> conditions(const NodesInData& nodes, std::size_t i) const;
  [[nodiscard]] Link link(const NodesInData& nodes, std::size_t i) const;
  [[nodiscard]] InData<Matrix> beginning(const NodesInData& nodes, std::size_t i) const;
  // How much theta, the duration and w change along the phases with each datum, in units of w and of what
  // grows in a time.
  [[nodiscard]] std::vector<double> changes(const NodesInData& nodes) const;
  [[nodiscard]] std::size_t data() const { return phases_.data(); }

  [[nodiscard]] const LinearPhases& phases() const { return phases_; }
  // (x, x') at node i.
  [[nodiscard]] Vector state(const Nodes& nodes, std::size_t i) const;
  // w there.
  [[nodiscard]] Vector beginning(const Nodes& nodes, std::size_t i) const;
  [[nodiscard]] Ball duration(const Nodes& nodes, std::size_t i) const;

 private:
  [[nodiscard]] Node next(const Nodes& nodes, std::size_t i) const;
  // The conditions of phase i where it has reached that.
  [[nodiscard]] Node conditions(const Nodes& nodes, std::size_t i, const Vector& reached) const;
  [[nodiscard]] InData<Matrix> conditions(const NodesInData& nodes, std::size_t i,
                                          const InData<Matrix>& reached) const;
  // Phase i from its node: w and w' at its ends, and where it is asked for the derivative of (x, x').
  [[nodiscard]] Passage course(const Nodes& nodes, std::size_t i, bool with_derivative) const;
  // How the time and (x, x') of a node depend on its numbers.
  [[nodiscard]] Spread spread() const;
  // Zero where phase i ends, as a row.
  [[nodiscard]] Vector event(std::size_t i) const;
  // For all machines likewise.
  [[nodiscard]] InData<Ball> duration(const NodesInData& nodes, std::size_t i) const;
  [[nodiscard]] PassageInData course(const NodesInData& nodes, std::size_t i, bool with_derivative) const;
  [[nodiscard]] InData<Matrix> event_in_data(std::size_t i) const;
  // (x, x') with x_j' put in, and without.
  [[nodiscard]] Vector with(const Ball& speed, const Node& node) const;
  template <class M>
  [[nodiscard]] M without(const M& state) const {
    return state(others_, Eigen::all);
  }

  bool autonomous_;
  std::vector<Piece> pieces_;
  LinearPhases phases_;
  std::vector<Eigen::Index> others_;  // rows of (x, x') but that of x_j'
  std::vector<Ball> speeds_;          // x_j' at the nodes
  Ball turn_;                         // of all periods
  // For all machines these.
  std::vector<InData<Ball>> speeds_in_data_;
  InData<Ball> omega_in_data_, turn_in_data_;
};

}  // namespace stickslip::numeric::machines
