// Chains of any machine: words/chain.hpp with the phases as linear systems.
//
// A node is (t, x, x' without x_j'), 2 n numbers for n masses. x_j' is the belt's velocity where a phase of
// another kind begins, and the one at which a piece of the friction law ends where another piece of it does;
// these are events, too. With a load t is the time, and theta = omega t. Without, each shift in time of a
// motion is a motion: there t is the duration of the phase that ends at the node, and the node before does
// not depend on it.
#pragma once

#include "numeric/machines/linear_phases.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/passage.hpp"
#include "numeric/words/chain.hpp"

namespace stickslip::numeric::machines {

struct MachineQuestion {
  Machine machine;
  std::vector<Piece> pieces;  // piece i begins at node i; neighbours differ
  long periods = 1;           // of the load, if there is one
};

class MachineChain : public words::Chain {
 public:
  explicit MachineChain(const MachineQuestion& question);

  [[nodiscard]] std::size_t size() const override { return pieces_.size(); }
  [[nodiscard]] words::Node conditions(const words::Nodes& nodes, std::size_t i) const override;
  [[nodiscard]] words::Link link(const words::Nodes& nodes, std::size_t i) const override;

  [[nodiscard]] const LinearPhases& phases() const { return phases_; }
  // (x, x') at node i.
  [[nodiscard]] Vector state(const words::Nodes& nodes, std::size_t i) const;
  // w there, and where phase i ends.
  [[nodiscard]] Vector beginning(const words::Nodes& nodes, std::size_t i) const;
  [[nodiscard]] Vector end(const words::Nodes& nodes, std::size_t i) const;
  [[nodiscard]] Ball duration(const words::Nodes& nodes, std::size_t i) const;

 private:
  [[nodiscard]] words::Node next(const words::Nodes& nodes, std::size_t i) const;
  // Phase i from its node: w and w' at its ends, and where it is asked for the derivative of (x, x').
  // Phase i from its node.
  [[nodiscard]] Passage course(const words::Nodes& nodes, std::size_t i, bool with_derivative) const;
  // Zero where phase i ends, as a row.
  [[nodiscard]] Vector event(std::size_t i) const;
  // Without x_j'.
  [[nodiscard]] Vector without(const Vector& state) const;

  bool autonomous_;
  std::vector<Piece> pieces_;
  LinearPhases phases_;
  std::vector<Ball> speeds_;  // x_j' at the nodes
  Ball turn_;                 // of all periods
};

[[nodiscard]] words::ChainAt chain_at(const MachineQuestion& question);

}  // namespace stickslip::numeric::machines
