// Chains of the paper's oscillator, by the closed forms of its flows (5), (8), (10).
//
// A node is u = (t, z1, z2, z1'). The load is cos omega t, so a node knows its phase and the phase of the
// load is no unknown. The event is z2' = V where a slip or an overshoot ends; r = ur where a stick ends
// before a slip, r = -ur before an overshoot.
#pragma once

#include "core/rational.hpp"
#include "numeric/motion/domain.hpp"
#include "numeric/motion/motion.hpp"
#include "numeric/words/chain.hpp"

namespace stickslip::numeric::words {

// What closed chains are asked for, exactly.
struct ChainQuestion {
  motion::ExactParameters data;
  Rational ur;
  std::vector<motion::PhaseKind> phases;  // phase i begins at node i
  long periods = 1;                       // n
};

[[nodiscard]] Node node(const Ball& t, const Ball& z1, const Ball& z2, const Ball& zdot1);

class OscillatorChain : public Chain {
 public:
  explicit OscillatorChain(const ChainQuestion& question);

  [[nodiscard]] const model::Oscillator<Ball>& oscillator() const { return oscillator_; }
  [[nodiscard]] const Ball& ur() const { return ur_; }

  [[nodiscard]] std::size_t size() const override { return phases_.size(); }
  [[nodiscard]] Node conditions(const Nodes& nodes, std::size_t i) const override;
  [[nodiscard]] Link link(const Nodes& nodes, std::size_t i) const override;
  // The motion that starts at node 0; phase i is that of node i.
  [[nodiscard]] motion::Motion motion(const Nodes& nodes) const;

 private:
  struct Flow;
  [[nodiscard]] Node next(const Nodes& nodes, std::size_t i) const;
  [[nodiscard]] Flow flow(const Node& from, const Ball& until, motion::PhaseKind kind) const;
  [[nodiscard]] Ball acceleration(motion::PhaseKind kind, const model::Vector4<Ball>& Z,
                                  const Ball& psi) const;

  std::vector<motion::PhaseKind> phases_;
  model::Oscillator<Ball> oscillator_;
  Ball ur_;
  Ball turn_;  // n Theta
};

[[nodiscard]] ChainAt chain_at(const ChainQuestion& question);

}  // namespace stickslip::numeric::words
