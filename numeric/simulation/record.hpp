// A simulated motion: where it starts, what it meets, and a record of it for readers.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "model/friction_oscillator.hpp"
#include "model/parameters.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::simulation {

// What the two ways of following a motion, closed form and raw law, have in common: where it starts and what
// it meets.

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

// By the raw law alone (raw_law.cpp) follows the motion for the duration, with an error of each step,
// relative and absolute, below 1e-12. Events by (4): x2' = V reached on a slip, where the mass sticks if |r|
// < ur and slips to the side of r otherwise; |r| = ur reached on a stick. With us = ur = |r| it slips only if
// |r| goes on to grow. Throws DomainError for a duration that is not finite and positive, InternalError when
// the steps become too small, the motion is not finite, or (4) leaves open what follows.
[[nodiscard]] Run follow_raw_law(const Start& start, double duration);

// The friction at rest (4) at the load phase psi.
[[nodiscard]] double friction_at_rest(const model::Parameters<double>& a, const model::Vector4<double>& X,
                                      double psi);

// A simulated motion as a record for readers: samples, events, shares, energy.

template <class State>
struct SampleOf {
  double time;
  motion::PhaseKind phase;
  State X;        // (x, x')
  double r, u;    // friction at rest, friction force
  double energy;  // of the masses and springs
};
using Sample = SampleOf<model::Vector4<double>>;

struct RecordPlan {
  double duration = 0;          // > 0
  std::optional<double> every;  // time between samples, > 0; without it there are none
};

struct Extremes {
  double least, greatest;
};

template <class State>
struct RecordOf {
  double period = 0;  // of the load; infinite without one
  double done = 0;    // the time simulated: less than planned after an interruption
  bool interrupted = false;
  long samples = 0;
  std::vector<TransitionOf<State>> first_events, last_events;  // at most `shown` each, without overlap
  long events = 0;
  std::array<double, 3> time_in{};  // by PhaseKind
  std::optional<Extremes> energy;   // of the samples, if there are any
  SampleOf<State> end{};

  static constexpr std::size_t shown = 12;
};

struct Record : RecordOf<model::Vector4<double>> {
  Start start;
};

// Simulates (2), (4) until the duration is over or `go_on`, asked with the share that is done after each
// sample and after some ten thousand steps without one, says no. Each sample is handed to `take`, if there is
// one, and not kept: at 0, every, 2 every, … and at the end. Throws DomainError as Simulation does, unless ur
// > us, as all that proves orbits asks for, and for a plan that is not positive or has more than 10⁹ samples.
[[nodiscard]] Record record_motion(const Start& start, const RecordPlan& plan,
                                   const std::function<bool(double)>& go_on,
                                   const std::function<void(const Sample&)>& take = {});

// The same of the motion of any oscillator from X with the load's phase phi.
using AnyState = Eigen::VectorXd;
[[nodiscard]] RecordOf<AnyState> record_motion(
    const model::FrictionOscillator<double>& oscillator, double phi, const AnyState& X,
    const RecordPlan& plan, const std::function<bool(double)>& go_on,
    const std::function<void(const SampleOf<AnyState>&)>& take = {});

}  // namespace stickslip::numeric::simulation
