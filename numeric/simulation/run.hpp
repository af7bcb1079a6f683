// What the two ways of following a motion, closed form and raw law, have in common: where it starts and what
// it meets.
#pragma once

#include <vector>

#include "model/parameters.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::simulation {

// The data of (2), (4) and a state at t = 0.
struct Start {
  model::Parameters<double> data;
  double ur = 0;
  double phi = 0;
  model::Vector4<double> X;  // (x1, x2, x1', x2')
};

// Where the motion changes from one phase to another, or from one piece of the friction law to the next.
template <class State>
struct TransitionOf {
  double time;  // since the motion began
  motion::PhaseKind before, after;
  double r;  // friction at rest (4) at that time
  State X;   // (x, x')
  int piece_before = 0, piece_after = 0;

  [[nodiscard]] bool changes() const { return before != after || piece_before != piece_after; }
};
using Transition = TransitionOf<model::Vector4<double>>;

struct Run {
  std::vector<Transition> transitions;
  model::Vector4<double> end;
};

// The friction at rest (4) at the load phase psi.
[[nodiscard]] double friction_at_rest(const model::Parameters<double>& a, const model::Vector4<double>& X,
                                      double psi);

}  // namespace stickslip::numeric::simulation
