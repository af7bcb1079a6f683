// The slip of one mass below a belt that runs forward, on a smooth law (planar_basin.hpp has the equations
// and the letters): what its motions do, in balls, and guesses of that in double.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/verdict.hpp"
#include "numeric/machines/machine.hpp"
#include "numeric/machines/phases/smooth_phase.hpp"

namespace stickslip::numeric::machines {

// In double, by Runge and Kutta's method.
class SlipGuess {
 public:
  explicit SlipGuess(const Machine& machine);

  // Where K is at velocity 0, behind steady sliding, and how long it takes. Nothing when it is not found.
  [[nodiscard]] std::optional<std::array<double, 2>> cycle() const;
  // A velocity at which h is positive: so it is between 0 and there, for it is concave.
  [[nodiscard]] double damped_up_to() const;
  // From T, of the motion in the belt's direction: the time at which it is fastest after a turn, or clearly
  // faster than the belt, or has clearly less energy about steady sliding than m/2 times the square of the
  // velocity above. Nothing when that takes long.
  [[nodiscard]] std::optional<double> telling_time() const;
  // From the belt at x, until it is met again.
  [[nodiscard]] std::optional<double> back_at_belt(double x) const;

 private:
  static constexpr double steps_in_radian = 300;
  static constexpr long most_steps = 200000;
  struct State {
    double x, y;
  };
  struct End {
    double behind, time;
  };
  [[nodiscard]] double acceleration(const State& s) const;
  [[nodiscard]] State step(const State& s, double h) const;
  // From so far behind steady sliding, at velocity 0, to there again; nothing when it meets the belt.
  [[nodiscard]] std::optional<End> turn(double behind) const;
  [[nodiscard]] bool leads_out(double behind) const;

  model::FrictionOscillator<double> o_;
  model::SmoothFriction<double> law_;
  double m_, c_, k_, V_, steady_, h_ = 0;
};

// The rows of a slip's state.
inline constexpr Eigen::Index position = 0, velocity = 1;

// A derivative of x or y at a time since the step's beginning.
[[nodiscard]] Ball value(const SmoothPhase::Step& step, Eigen::Index row, int derivative, const Ball& s);

// Times of one step, from its beginning.
struct Stretch {
  const SmoothPhase::Step& step;
  Ball from, to;

  [[nodiscard]] Ball over(Eigen::Index row, int derivative = 0) const {
    const Ball all = Ball::hull(from, to), middle = all.midpoint();
    return value(step, row, derivative, middle) + value(step, row, derivative + 1, all) * (all - middle);
  }
};

// The stretches of the phase up to T in their order, halved until `take` takes them; whether it took all.
template <class Take>
[[nodiscard]] bool takes_all(const Stretch& stretch, const Take& take, int depth = 0) {
  if (take(stretch)) {
    return true;
  }
  if (depth == WorkingPrecision::bits()) {
    return false;
  }
  const Ball middle = Ball::hull(stretch.from, stretch.to).midpoint();
  return takes_all(Stretch{stretch.step, stretch.from, middle}, take, depth + 1) &&
         takes_all(Stretch{stretch.step, middle, stretch.to}, take, depth + 1);
}
template <class Take>
[[nodiscard]] bool takes_all(const SmoothPhase& phase, const Ball& T, const Take& take) {
  for (const SmoothPhase::Step& step : phase.steps()) {
    const bool last = &step == &phase.steps().back();
    if (!takes_all(Stretch{step, Ball(0), last ? T - Ball(step.start) : Ball(step.length)}, take)) {
      return false;
    }
  }
  return !phase.steps().empty();
}

class PlanarSlip {
 public:
  // At the working precision, which its methods must not exceed.
  explicit PlanarSlip(const Machine& machine);
  PlanarSlip(const PlanarSlip&) = delete;
  PlanarSlip& operator=(const PlanarSlip&) = delete;

  // Of "steady sliding is asymptotically stable".
  [[nodiscard]] Verdict steady_sliding_is_stable() const;
  // Of "K exists", by 3, where steady sliding is stable.
  [[nodiscard]] Verdict cycle_exists() const;
  // The parts of a turn of K from velocity 0, each with what is so along it: y' > 0, y > 0, y' < 0, y < 0 and
  // y' > 0; so it is one turn only. And it stays below the belt.
  [[nodiscard]] bool is_turn_below_belt(const SmoothPhase& phase, const Ball& T) const;
  // From the belt at x, right of where it could stick: where the belt is met again, first; nothing where that
  // is not enclosed. `take` is handed all stretches before.
  template <class Take>
  [[nodiscard]] std::optional<Ball> back_at_belt(const Ball& x, const Take& take) const {
    constexpr double near = 0x1p-16;
    const std::optional<double> guess = SlipGuess(machine_).back_at_belt(x.approximate());
    if (!guess) {
      return std::nullopt;
    }
    const Ball T(*guess * (1 + near));
    const double from = *guess * (1 - near);
    const SmoothPhase phase = follow(x, o().V, T, false);
    std::optional<Ball> where;
    const bool done = stays_below(phase, T, 1, [&](const Stretch& s, bool is_below) {
      if (!is_below && s.step.start + s.from.approximate() >= from && s.over(velocity).is_positive()) {
        where = where ? Ball::hull(*where, s.over(position)) : s.over(position);
        is_below = true;
      }
      return is_below && take(s);
    });
    return done && Ball(phase.end()(velocity) - o().V).is_positive() ? where : std::nullopt;
  }

  // From (x, y) over T.
  [[nodiscard]] SmoothPhase follow(const Ball& x, const Ball& y, const Ball& T, bool with_derivative) const;
  [[nodiscard]] Ball acceleration(const Vector& w) const { return smooth_rate(phases_, 1, w)(velocity); }
  [[nodiscard]] Ball steady() const { return law_.force(o().V) / o().stiffness(0, 0); }
  [[nodiscard]] const model::FrictionOscillator<Ball>& o() const { return phases_.oscillator(); }

 private:
  // From T.
  [[nodiscard]] SmoothPhase from_belt(const Ball& time) const;
  // Whether the motion from the belt is below it from then on up to T. So it is at first, where a derivative
  // of y is negative and those before are 0 or negative at the belt. `take` decides on each stretch, knowing
  // whether it is below.
  template <class Take>
  [[nodiscard]] bool stays_below(const SmoothPhase& phase, const Ball& T, int derivative,
                                 const Take& take) const {
    bool begins = true;
    return takes_all(phase, T, [&](const Stretch& s) {
      const bool taken = take(s, begins ? s.over(velocity, derivative).is_negative()
                                        : Ball(o().V - s.over(velocity)).is_positive());
      begins = begins && !taken;
      return taken;
    });
  }
  // Whether the motion from T is below the belt until the time, and then it is clear that it stays there.
  // Either it speeds up and at last slows down again: then it has passed from y' > 0 to y' < 0 below the
  // belt, which it does between the belt and steady sliding. Or its energy about steady sliding, which
  // changes by -y h(y), falls from there on.
  [[nodiscard]] bool stays_away(const Ball& time, const Ball& damped_up_to) const;

  Machine machine_;
  LinearPhases phases_;
  const model::SmoothFriction<Ball>& law_;
};

}  // namespace stickslip::numeric::machines
