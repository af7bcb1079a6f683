// What a simulated motion settles on, of any oscillator. In doubles: it proposes, and proves nothing.
//
// With a load the state is looked at once in a period of it, when its phase is 0. A motion has settled when
//   it is known to have no event any more,
//   it comes back, after n periods, to where it was, up to a small part of its size.
// The state is compared with the one at the last period whose number is a power of two (Brent's method), so
// that transients go and n is found without being asked for. Without a load the same is done with the states
// at events, counted as periods are; a motion that has no more of them slides or sticks.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/attractors/many_starts.hpp"
#include "numeric/machines/orbits/machine_orbit.hpp"
#include "numeric/simulation/simulation.hpp"

namespace stickslip::numeric::attractors {

// The distance of two states (x, x') in units of their size, x being taken times Omega: forces and times of
// an oscillator in SI units make positions far smaller than velocities.
template <class A, class B>
[[nodiscard]] double distance(const Eigen::MatrixBase<A>& X, const Eigen::MatrixBase<B>& Y,
                              double Omega = 1) {
  const Eigen::Index n = X.size() / 2;
  const auto size = [&](const auto& Z) {
    return std::max(Omega * Z.head(n).template lpNorm<Eigen::Infinity>(),
                    Z.tail(n).template lpNorm<Eigen::Infinity>());
  };
  const double apart = size((X - Y).eval());
  return apart == 0 ? 0 : apart / std::max(size(X), size(Y));
}

// A motion over n periods of the load, or round once where there is none.
struct Return {
  machines::MachineGuess guess;       // its events, counted from a time of load phase 0 or from the first
  std::string word;                   // their letters, in the first rotation; perhaps no word
  std::vector<Eigen::VectorXd> once;  // the states when each of the n periods, or of the phases, begins
};

// One that goes round a shorter one several times, up to this distance, as that one.
[[nodiscard]] Return shortest(const Return& seen, bool has_load, double nearness, double Omega);

// The largest Lyapunov exponent of a simulated motion: a check, no proof.

// Per period of the load: a small deviation grows by exp(value) in each, in the mean.
struct Exponent {
  double value = 0;
  double error = 0;  // its standard error, from blocks
  // What a finite time may leave of an exponent that is zero: on a torus deviations grow in proportion to
  // time.
  double least = 0;

  [[nodiscard]] bool is_positive() const { return value > 3 * error && value > least; }
  [[nodiscard]] bool is_negative() const { return -value > 3 * error && -value > least; }
  // Zero as far as a long time tells: what it leaves is positive.
  [[nodiscard]] bool is_zero() const { return -value < least / 3 && value < least && least < 0.0015; }
};

// Follows one motion. What is said of periods is said of events where there is no load.
class AnyFollower {
 public:
  explicit AnyFollower(bool has_load) : has_load_(has_load) {}
  virtual ~AnyFollower() = default;

  // Goes on until the motion has settled, or so many periods are over in all. `nearness` is the distance that
  // counts as a return; a motion that was followed before is looked at again when it is twice as old. Slides
  // and stuck for good also when no event came in the last half, or none on the way back to within 1e-9.
  // Stops when it is interrupted, and where a period of the load takes more than two million steps.
  virtual void follow(long most_periods, double nearness) = 0;

  // Unsettled after all periods: quasi-periodic or irregular by the largest Lyapunov exponent over so many
  // more, if that tells; without a load it does not.
  virtual void classify(long periods) = 0;

  // The motion is not where it seemed to return.
  void reject() { kind_ = Kind::unsettled; }

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] long periods() const { return periods_; }
  // Whether it has settled, or gone through so many periods, or cannot be followed.
  [[nodiscard]] bool is_followed(long most_periods) const {
    return kind_ != Kind::unsettled || periods_ >= most_periods || is_too_slow_;
  }
  // A period of the load takes too many steps to be followed.
  [[nodiscard]] bool is_too_slow() const { return is_too_slow_; }
  // Of a motion that settled as periodic, over its own period.
  [[nodiscard]] std::optional<Return> returned() const {
    return kind_ == Kind::periodic ? std::optional(return_) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> lyapunov() const { return lyapunov_; }
  [[nodiscard]] virtual Eigen::VectorXd state() const = 0;

  // The n periods of the load that follow, from a time when its phase is 0.
  [[nodiscard]] virtual Return over_periods(long n) const = 0;
  // The fewest periods of the load, at most 8, in which the motion goes through one word again and again, and
  // the first of these repetitions; nothing where there is none, and without a load.
  [[nodiscard]] std::optional<Return> steady_word() const;
  // Whether the motion, seen every n periods, comes nearer to X as motions do that near a stable orbit with a
  // largest multiplier of the size mu: its farthest in the middle of so many periods is less than in the
  // beginning, and in the end less than in the middle, both by mu to the power of the returns between, within
  // a factor 2 of the exponent. A check; less than a part in 1000 is not distinguished from a torus.
  [[nodiscard]] virtual bool nears(const Eigen::VectorXd& X, double mu, long n, long periods) const = 0;

 protected:
  bool has_load_;
  Kind kind_ = Kind::unsettled;
  long periods_ = 0;
  long last_event_ = 0;  // the period in which it was
  bool is_too_slow_ = false;
  Return return_;
  std::optional<double> lyapunov_;
};

template <int N, int L>
class FollowerOf : public AnyFollower {
 public:
  using Simulation = simulation::SimulationOf<N, L>;
  using State = typename Simulation::State;
  // What is known of a motion that had no event in the last period: that it slides or sticks for good.
  using ForGood = std::function<std::optional<Kind>(const Simulation&)>;

  // Follows the simulation, of this oscillator, that has just begun at load phase 0.
  FollowerOf(const model::FrictionOscillator<double>& oscillator, const Simulation& begun, double Omega,
             ForGood for_good = {})
      : AnyFollower(!oscillator.is_autonomous()),
        o_(oscillator),
        simulation_(begun),
        Omega_(Omega),
        for_good_(std::move(for_good)) {}

  void follow(long most_periods, double nearness) override;
  void classify(long periods) override;
  [[nodiscard]] Eigen::VectorXd state() const override { return simulation_.state(); }
  [[nodiscard]] Return over_periods(long n) const override;
  [[nodiscard]] bool nears(const Eigen::VectorXd& X, double mu, long n, long periods) const override;
  // The largest Lyapunov exponent: from the motion and a neighbour that is brought back to a small distance
  // after each of so many periods, after a lead of a fifth as many. Assumes a load, whose phase is 0 now. One
  // that is interrupted says nothing.
  [[nodiscard]] Exponent exponent(long periods) const;

 private:
  using Transition = typename Simulation::Transition;

  void follow_periods(long most_periods, double nearness);
  void follow_events(long most_events, double nearness);
  // False when it was stopped, or has settled, before the period was over.
  [[nodiscard]] bool goes_through_period(std::vector<Transition>& log);
  // Whether the motion that has come back to this distance after n periods is taken for a periodic one; then
  // it is the return.
  [[nodiscard]] bool returns(long n, double distance);
  [[nodiscard]] Kind without_events() const {
    return simulation_.phase() == motion::PhaseKind::stick ? Kind::stuck : Kind::slides;
  }

  model::FrictionOscillator<double> o_;
  Simulation simulation_;
  double Omega_;
  ForGood for_good_;
};

extern template class FollowerOf<2, 1>;
extern template class FollowerOf<Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace stickslip::numeric::attractors
