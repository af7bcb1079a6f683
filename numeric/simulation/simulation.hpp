// The motion under the friction law (2), (4) in closed form and double, from any state, for long runs.
//
// A slip is carried on in modal coordinates, a stick by (9), both by steps in which an event is excluded by
// Taylor polynomials with a bound of the fourth derivative, not by signs at the ends; where it cannot be
// excluded the steps shrink towards the first zero from the left. So no event is missed, up to rounding: a
// distance that falls below some 10 units in the last place counts as zero.
//
// What happens, by (4), with r the friction at rest:
//   contact with the belt, |r| < ur     stick (also when the belt is only grazed)
//   contact, |r| >= ur                  the side to which r pulls: below for r > 0, above for r < 0; so the
//                                       belt is crossed, or left again to the same side
//   |r| reaches ur during stick         break-away to the side to which r pulls, with the force ±us
// At |r| = ur exactly, where (4) says nothing, the mass slips. With us = ur it slips only if r goes on to
// grow; else it stays.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "numeric/simulation/run.hpp"
#include "numeric/simulation/slip_phase.hpp"
#include "numeric/simulation/stick_phase.hpp"

namespace stickslip::numeric::simulation {

class Simulation {
 public:
  // Starts at X = (x1, x2, x1', x2') with the load's phase phi. Throws DomainError unless 1e-100 <= chi < 1,
  // 1e-20 <= eta <= 1e20, 1e-100 <= omega <= 1e10, 0 < us <= ur <= 1e100, 0 <= p <= 1e100, and V and the
  // state are within ±1e100.
  Simulation(const model::Parameters<double>& a, double ur, double phi, const model::Vector4<double>& X);

  // Goes on for a time >= 0, in at most so many steps and events; transitions are appended to `log` if there
  // is one. Returns what is left of the time, which goes on where it stopped when that is asked for next.
  double advance(double duration, std::vector<Transition> * log = nullptr,
                 long most_steps = std::numeric_limits<long>::max());

  [[nodiscard]] double time() const { return static_cast<double>(periods_) * Theta_ + t_; }
  [[nodiscard]] motion::PhaseKind phase() const { return kind_; }
  [[nodiscard]] model::Vector4<double> state() const;
  // The friction at rest r of (4), and the friction force u: ±us, or r.
  [[nodiscard]] double friction_at_rest() const;
  [[nodiscard]] double friction() const;
  // Time spent so far in a kind of phase.
  [[nodiscard]] double time_in(motion::PhaseKind kind) const {
    return spent_[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] double period() const { return Theta_; }
  [[nodiscard]] const model::Parameters<double>& data() const { return a_; }
  [[nodiscard]] double ur() const { return ur_; }

 private:
  enum class Outcome { reached, contact };

  [[nodiscard]] double phase_of_load() const;
  [[nodiscard]] bool goes_on() const { return left_ > 0 && steps_ > 0; }
  void normalise();
  void passed(double h);
  Outcome slip();
  Outcome stick();
  [[nodiscard]] int order_of_zero(Expansion& g) const;
  void contact(std::vector<Transition> * log);
  void break_away(std::vector<Transition> * log);
  [[nodiscard]] bool leaves(const model::Vector4<double>& X, int side, double r) const;
  void begin(motion::PhaseKind kind, const model::Vector4<double>& X, double exit_slope);
  void leave_or_stick(const model::Vector4<double>& X, double r, std::vector<Transition> * log);

  model::Parameters<double> a_;
  double ur_, phi_, Theta_;
  SlipData slip_data_;
  SlipStep slip_step_;
  StickStep stick_step_;

  motion::PhaseKind kind_ = motion::PhaseKind::slip;
  SlipPhase slip_;
  StickPhase stick_;
  long periods_ = 0;  // the time is periods Theta + t
  double t_ = 0;
  double left_ = 0;         // of the duration asked for
  long steps_ = 0;          // and of the steps
  double age_ = 0;          // time since the last transition
  bool fresh_ = false;      // the slip has just begun at x2' = V
  double exit_slope_ = 0;   // then, the rate at which it leaves the belt
  double hold_ = 0;         // for so long no event is looked for: |r| = ur, and the mass does not slip
  double hold_length_ = 0;  // of the last time it was held
  int standstill_ = 0;      // transitions in a row between which no time passed
  std::array<double, 3> spent_{};
};

}  // namespace stickslip::numeric::simulation
