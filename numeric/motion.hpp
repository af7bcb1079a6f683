// A piecewise motion as data: slip, overshoot and stick phases one after the other, in balls.
//
// Time is dimensionless (3) and counted from the start of the first phase; z =
// x
// - d0, V and the friction forces are lengths.
#pragma once

#include <string>
#include <vector>

#include "core/ball.hpp"
#include "model/waves.hpp"
#include "numeric/scalars.hpp"

namespace stickslip {

enum class PhaseKind {
  slip,       // x2' < V, u = us: (5)
  overshoot,  // x2' > V, u = -us: (8)
  stick,      // x2' = V: (10)
};

[[nodiscard]] std::string to_string(PhaseKind kind);

struct Phase {
  PhaseKind kind = PhaseKind::slip;
  Ball start;              // time at which it begins
  Ball duration;           // >= 0
  Ball load;               // the load's phase omega t + phi when it begins
  model::Vector4<Ball> Z;  // (z, z') when it begins
};

struct Motion {
  model::Oscillator<Ball> oscillator;
  std::vector<Phase> phases;
};

// A kind of phase and how long it lasts.
struct Leg {
  PhaseKind kind = PhaseKind::slip;
  Ball duration;
};

// The motion that starts at Z0 and goes through the legs in their order, each from the state where the one
// before ends. Whether it obeys the friction law and whether it closes is not looked at.
[[nodiscard]] Motion compose(const model::Oscillator<Ball>& oscillator, const Ball& phi,
                             const model::Vector4<Ball>& Z0, const std::vector<Leg>& legs);

// Z at the time t after phase k began, by the flow of that phase, also for t outside its duration.
[[nodiscard]] model::Vector4<Ball> state(const Motion& motion, std::size_t k, const Ball& t);

// The friction at rest r of (4) at the time t after phase k began.
[[nodiscard]] Ball friction(const Motion& motion, std::size_t k, const Ball& t);

// The same coordinates as functions of the time since phase k began.
[[nodiscard]] model::PhaseWaves<Ball> waves(const Motion& motion, std::size_t k);

// The sum of all durations: the period, if the motion closes.
[[nodiscard]] Ball period(const Motion& motion);

// A ball around Z at time t after the motion began, 0 <= t <= period: the hull over the phases that t may lie
// in. Assumes at least one phase.
[[nodiscard]] model::Vector4<Ball> state_at(const Motion& motion, const Ball& t);

// Where phase k ends minus where the next one begins, one vector per phase; after the last phase comes the
// first. An orbit has zero in all of them, and a ball that excludes zero proves that the motion is none.
[[nodiscard]] std::vector<model::Vector4<Ball>> gaps(const Motion& motion);
// The same from waves of all phases that are known already.
[[nodiscard]] std::vector<model::Vector4<Ball>> gaps(const Motion& motion,
                                                     const std::vector<model::PhaseWaves<Ball>>& all_waves);
[[nodiscard]] std::vector<model::PhaseWaves<Ball>> all_waves(const Motion& motion);

}  // namespace stickslip
