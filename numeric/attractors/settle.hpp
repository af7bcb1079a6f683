// What a simulated motion settles on. In doubles: it proposes, and proves nothing.
//
// The state is looked at once in a period of the load, when its phase is 0. A motion has settled when
//   it slips, and the three harmonics of its speed can never again add up to the belt's,
//   it sticks to a belt that stands still, and its friction at rest can never again reach ur,
//   it comes back after n periods to where it was, up to a small part of its size.
// The state is compared with the one at the last period whose number is a power of two (Brent's method), so
// that transients go and n is found without being asked for.
#pragma once

#include <optional>
#include <vector>

#include "numeric/attractors/kind.hpp"
#include "numeric/simulation/simulation.hpp"
#include "numeric/words/word_orbit.hpp"

namespace stickslip::numeric::attractors {

// A motion over n periods of the load.
struct Return {
  words::Guess guess;                        // its events, counted from a time of load phase 0
  std::string word;                          // their letters, in the first rotation; perhaps no word
  std::vector<model::Vector4<double>> once;  // the states at the beginning of each of the n periods
};

// The n periods that follow, from a time when the load's phase is 0.
[[nodiscard]] Return over_periods(simulation::Simulation simulation, long n);

// The state of the motion when the load's phase is next a multiple of 2 pi.
[[nodiscard]] model::Vector4<double> at_phase_0(const simulation::Start& start);

// The fewest periods, at most 8, in which a motion goes through one word again and again, and the first of
// these repetitions; nothing where there is none.
[[nodiscard]] std::optional<Return> steady_word(const simulation::Simulation& simulation);

// Whether the motion, seen every n periods, comes nearer to X as motions do that near a stable orbit with a
// largest multiplier of the size mu: its farthest in the middle of so many periods is less than in the
// beginning, and in the end less than in the middle, both by mu to the power of the returns between, within a
// factor 2 of the exponent. A check; less than a part in 1000 is not distinguished from a torus.
[[nodiscard]] bool nears(simulation::Simulation simulation, const model::Vector4<double>& X, double mu,
                         long n, long periods);

class Follower {
 public:
  // From X at t = 0, the load being cos omega t. Throws as Simulation does.
  Follower(const model::Parameters<double>& a, double ur, const model::Vector4<double>& X);

  // Goes on until the motion has settled, or so many periods are over in all. `nearness` is the relative
  // distance that counts as a return; a motion that was followed before is looked at again when it is twice
  // as old. Slides and stuck for good also when no event came in the last half.
  // Stops when it is interrupted, and where a period of the load takes more than two million steps.
  void follow(long most_periods, double nearness);

  // Unsettled after all periods: quasi-periodic or irregular by the largest Lyapunov exponent over so many
  // more, if that tells.
  void classify(long periods);

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
  // Of a motion that settled as periodic, over its own period; nothing when its events make no word.
  [[nodiscard]] std::optional<Return> returned() const;
  [[nodiscard]] std::optional<double> lyapunov() const { return lyapunov_; }
  [[nodiscard]] const simulation::Simulation& simulation() const { return simulation_; }

 private:
  [[nodiscard]] bool slides_for_good() const;
  [[nodiscard]] bool sticks_for_good() const;
  // False when it was stopped, or has settled, before the period was over.
  [[nodiscard]] bool goes_through_period(std::vector<simulation::Transition>& log);

  simulation::Simulation simulation_;
  model::Oscillator<double> oscillator_;
  Kind kind_ = Kind::unsettled;
  long periods_ = 0;
  long period_ = 0;      // n
  long last_event_ = 0;  // the period in which it was
  bool is_too_slow_ = false;
  std::optional<double> lyapunov_;
};

// The distance of two states in units of their size.
[[nodiscard]] double distance(const model::Vector4<double>& X, const model::Vector4<double>& Y);

}  // namespace stickslip::numeric::attractors
