// The motion of a friction oscillator in double, from any state, for long runs.
//
// A phase is linear, so a step of it is a Taylor polynomial, and an event is excluded on it by bounds, not by
// signs at its ends; where it cannot be excluded the time goes on towards the first zero from the left. So no
// event is missed, up to rounding: a distance that falls below some 10 units in the last place counts as
// zero.
//
// What happens, with r the friction at rest and ur its bound to the side to which it pulls:
//   contact with the belt, |r| < ur     stick (also when the belt is only grazed)
//   contact, |r| >= ur                  the side to which r pulls: below for r > 0, above for r < 0; so the
//                                       belt is crossed, or left again to the same side
//   |r| reaches ur during stick         break-away to the side to which r pulls
//   an end of a piece of the law        the next piece
// At |r| = ur exactly, where the law says nothing, the mass slips. Where the friction drops by nothing it
// slips only if r goes on to grow; else it stays.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "model/friction_oscillator.hpp"
#include "numeric/simulation/record.hpp"
#include "numeric/simulation/taylor.hpp"

namespace stickslip::numeric::simulation {

// N masses and forces of L different frequencies; Eigen::Dynamic for numbers that are known when the program
// runs.
template <int N, int L>
class SimulationOf {
 public:
  static constexpr int states = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N;
  using State = Eigen::Matrix<double, states, 1>;  // (x, x')
  using Transition = TransitionOf<State>;

  // Starts at X with the load's phase phi. Assumes masses > 0, omega > 0 where a load varies, and a sliding
  // friction that is at most the one at rest where it begins.
  SimulationOf(const model::FrictionOscillator<double>& oscillator, double phi, const State& X);

  // The same oscillator from another start, at time 0.
  void restart(double phi, const State& X);

  // Goes on for a time >= 0, in at most so many steps and events; transitions are appended to `log` if there
  // is one. Returns what is left of the time, which goes on where it stopped when that is asked for next.
  double advance(double duration, std::vector<Transition> * log = nullptr,
                 long most_steps = std::numeric_limits<long>::max());

  [[nodiscard]] double time() const {
    return periods_ == 0 ? t_ : static_cast<double>(periods_) * Theta_ + t_;
  }
  [[nodiscard]] motion::PhaseKind phase() const { return pieces_[now_].kind; }
  [[nodiscard]] State state() const { return w_.template head<states>(2 * n_); }
  // The friction at rest r, and the friction force u: that of sliding, or r.
  [[nodiscard]] double friction_at_rest() const;
  [[nodiscard]] double friction() const;
  // Time spent so far in a kind of phase.
  [[nodiscard]] double time_in(motion::PhaseKind kind) const {
    return spent_[static_cast<std::size_t>(kind)];
  }
  // Of the load; infinite where none varies.
  [[nodiscard]] double period() const { return Theta_; }

 private:
  static constexpr int size = N == Eigen::Dynamic || L == Eigen::Dynamic ? Eigen::Dynamic : 2 * N + 1 + 2 * L;
  using Whole = Eigen::Matrix<double, size, 1>;  // (x, x', 1, cosine and sine of the phase of each frequency)
  enum class Outcome { reached, contact };

  // A linear piece of the motion.
  struct Piece {
    motion::PhaseKind kind = motion::PhaseKind::stick;
    int number = 0;           // among those of its side, from 0
    double from = 0, to = 0;  // relative velocities
    double force = 0;         // u = force - slope x_j'
    double slope = 0;
    double step = 0;                                 // length of a whole step
    Eigen::Matrix<double, N, size> rates;            // x'' of the numbers
    Eigen::Matrix<double, size, size> flow;          // over a whole step
    Eigen::Matrix<double, order + 1, size> watched;  // the Series of r on a stick, of x_j' else,
    Whole rest;                                      // the rest of its Cubic, of the sizes of the numbers;
    Whole terms;                                     // what rounding can do to it
    [[nodiscard]] int side() const {
      return kind == motion::PhaseKind::slip ? 1 : (kind == motion::PhaseKind::overshoot ? -1 : 0);
    }
  };
  // sign f + offset, f what is watched; `begins`: it is zero now.
  struct Guard {
    double sign, offset;
    bool begins;
  };
  void add_pieces(int side, const model::FrictionLaw<double>& law, Piece * place) const;
  void prepare(Piece& piece);
  [[nodiscard]] double fastest(const Eigen::MatrixXd& rates) const;
  void set_load();
  void derive(const Piece& piece, double scale, Whole& term);
  void go_on_for(double part);
  [[nodiscard]] bool goes_on() const { return left_ > 0 && steps_ > 0; }
  void normalise();
  void passed(double part);
  Outcome step();
  Outcome part_of_step(double part, double rounding);
  [[nodiscard]] Cubic watched() const;
  [[nodiscard]] std::array<Guard, 2> guards() const;
  [[nodiscard]] std::pair<double, bool> free_part(const Guard& guard, double part, double beyond,
                                                  double rounding) const;
  void contact(std::vector<Transition> * log);
  void pass_end_of_piece(bool upper, std::vector<Transition> * log);
  void leave_or_stick(double r, std::vector<Transition> * log);
  [[nodiscard]] bool leaves(int side, double r) const;
  void begin(std::ptrdiff_t piece, double exit_slope);
  [[nodiscard]] std::ptrdiff_t first_piece(int side) const;
  [[nodiscard]] double bound(int side) const { return side > 0 ? forward_ : backward_; }

  // x'' without friction, of the numbers.
  Eigen::Matrix<double, N, size> rates_;
  Eigen::Matrix<double, L, 1> frequencies_;
  Eigen::Index n_, j_, L_ = 0;
  double m_, V_, forward_, backward_, omega_, phi_ = 0, Theta_;
  std::shared_ptr<const Piece[]> pieces_;  // the stick, those of a slip, those of an overshoot

  Whole w_, term_;  // the numbers now, and a term of their Taylor polynomials
  Eigen::Matrix<double, N, 1> acceleration_;
  std::ptrdiff_t now_ = 0;  // the piece
  Series watched_{};        // over a step
  long periods_ = 0;        // the time is periods Theta + t
  double t_ = 0;
  double left_ = 0;         // of the duration asked for
  long steps_ = 0;          // and of the steps
  double age_ = 0;          // time since the last transition
  bool fresh_ = false;      // the phase has just begun at an end of its piece, the lower one or, if
  bool at_upper_ = false;   // this says so, the upper one;
  double exit_slope_ = 0;   // then, the rate at which it leaves that end
  bool upper_end_ = false;  // the contact is at the upper end of the piece
  double hold_ = 0;         // for so long no event is looked for: |r| = ur, and the mass does not slip
  double hold_length_ = 0;  // of the last time it was held
  int standstill_ = 0;      // transitions in a row between which no time passed
  std::array<double, 3> spent_{};
};

extern template class SimulationOf<2, 1>;
extern template class SimulationOf<Eigen::Dynamic, Eigen::Dynamic>;
using AnySimulation = SimulationOf<Eigen::Dynamic, Eigen::Dynamic>;

// Of the paper's oscillator, (2) and (4).
class Simulation : public SimulationOf<2, 1> {
 public:
  // Starts at X = (x1, x2, x1', x2') with the load's phase phi. Throws DomainError unless 1e-100 <= chi < 1,
  // 1e-20 <= eta <= 1e20, 1e-100 <= omega <= 1e10, 0 < us <= ur <= 1e100, 0 <= p <= 1e100, and V and the
  // state are within ±1e100.
  Simulation(const model::Parameters<double>& a, double ur, double phi, const model::Vector4<double>& X);
};

}  // namespace stickslip::numeric::simulation
