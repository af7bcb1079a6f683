// The phases of a friction oscillator (model/friction_oscillator.hpp) as linear systems, in balls.
//
// w = (x, x', 1, cos k theta, sin k theta for each multiple k of the load's frequency) obeys w' = B w on each
// piece of its motion, and what the friction law compares, r and the relative velocity, are rows times w.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "model/friction_oscillator.hpp"
#include "numeric/machines/phases/exponential.hpp"
#include "numeric/machines/phases/numbers_in_data.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::machines {

// A phase, and for slips and overshoots which piece of the friction law it is on.
struct Piece {
  motion::PhaseKind kind = motion::PhaseKind::stick;
  int number = 0;

  [[nodiscard]] static Piece sliding(int side, int number = 0) {
    return {side > 0 ? motion::PhaseKind::slip : motion::PhaseKind::overshoot, number};
  }
  [[nodiscard]] int side() const {
    return kind == motion::PhaseKind::slip ? 1 : (kind == motion::PhaseKind::overshoot ? -1 : 0);
  }
  friend auto operator<=>(const Piece&, const Piece&) = default;
};

class LinearPhases {
 public:
  explicit LinearPhases(const model::FrictionOscillator<Ball>& oscillator);
  // Of all machines whose numbers are these functions of data.
  explicit LinearPhases(const OscillatorInData& machines);
  [[nodiscard]] bool is_over_data() const { return machines_.has_value(); }
  [[nodiscard]] std::size_t data() const { return machines_ ? machines_->data : 0; }

  [[nodiscard]] const model::FrictionOscillator<Ball>& oscillator() const { return oscillator_; }
  [[nodiscard]] Eigen::Index masses() const { return n_; }
  [[nodiscard]] Eigen::Index rubbing() const { return static_cast<Eigen::Index>(oscillator_.rubbing); }
  // Where w has x_j', and the other rows of (x, x').
  [[nodiscard]] Eigen::Index speed_row() const { return n_ + rubbing(); }
  [[nodiscard]] std::vector<Eigen::Index> rows_but_speed() const;

  // Whether the friction on the piece follows a smooth law: then it is no part of B, and what is said of
  // flows and watches does not hold (smooth_phase.hpp).
  [[nodiscard]] bool is_smooth(Piece piece) const {
    return piece.side() != 0 && oscillator_.law(piece.side()).smooth;
  }
  // B of the piece. Throws InternalError when the law has no such piece.
  [[nodiscard]] const Matrix& drift(Piece piece) const;
  // exp(B h), for all members of h. Those that were computed for one time are kept, and serve those beside
  // it: where at most two masses move, without dashpots and with friction that does not change with the
  // speed, in closed form as (5) and (10), else by Arb.
  [[nodiscard]] Matrix flow(Piece piece, const Ball& h) const;
  // That times w.
  [[nodiscard]] Vector after(Piece piece, const Ball& h, const Vector& w) const;
  // Those of the machine, or of all: S is Ball or InData<Ball>.
  template <class S>
  [[nodiscard]] const model::FrictionOscillator<S>& numbers() const {
    if constexpr (std::is_same_v<S, Ball>) {
      return oscillator_;
    } else {
      return machines_->numbers;
    }
  }
  // As functions of the data: a number of the oscillator; and what ends the piece, r on a stick and x_j'
  // else, as a row.
  template <class F>
  [[nodiscard]] InData<Ball> number(const F& of) const {
    return machines_ ? InData<Ball>(of(machines_->numbers)) : InData<Ball>(Ball(of(oscillator_)));
  }
  [[nodiscard]] InData<Matrix> watched(Piece piece) const;
  // For all machines: B, exp(B h), and w from (x, x') and theta.
  [[nodiscard]] const InData<Matrix>& drift_in_data(Piece piece) const;
  [[nodiscard]] InData<Matrix> flow(Piece piece, const InData<Ball>& h) const;
  [[nodiscard]] InData<Matrix> whole(const InData<Matrix>& state, const InData<Ball>& theta) const;

  // What ends the piece, r on a stick and x_j' else, f = row w, and how its Taylor polynomials are bounded.
  // With the sizes of the numbers of w balanced by S, diagonal, and nu = |S B S⁻¹| in the norm of row sums,
  // the term of order m at r is at most |row S⁻¹| |S w| (nu r)^m/m!.
  using Rest = std::array<Ball, 6>;
  struct Watch {
    Matrix rows;     // row B^m/m!, as many as the working precision sees
    Vector balance;  // S
    Ball size, nu;   // |row S⁻¹|
    double length;   // of a stretch, a power of two: nu length <= 2 or so
    // What the rows leave out of the derivative number i of f on a stretch is at most |S w| size times this;
    // not finite unless nu length is small beside the number of rows.
    Rest rest;
    Matrix flow;  // over a stretch
  };
  // Kept. `reversed`: with -B in place of B, for what is seen from the end of a phase.
  [[nodiscard]] const Watch& watch(Piece piece, bool reversed) const;

  // Of w, powers of two: how far and how fast motions go, and 1.
  [[nodiscard]] const Vector& units() const { return units_; }

  // w from (x, x') and the load's phase theta.
  [[nodiscard]] Vector whole(const Vector& state, const Ball& theta) const;
  // r, x_j' and the constant 1 as rows.
  [[nodiscard]] const Vector& friction_at_rest() const { return r_; }
  [[nodiscard]] Vector speed() const;
  [[nodiscard]] Vector one() const;

 private:
  struct Exponential {
    Ball middle;
    Matrix of_middle;
    InData<Matrix> in_data;  // for all machines
  };
  // exp(B h) of a polynomial in the data, without a rest.
  struct OverTime {
    InData<Ball> h;
    InData<Matrix> flow;
  };
  // exp(B t), each entry a combination of 1, t, and the cosine and sine of t times each frequency: the
  // natural ones of the masses that move, and those of the load.
  struct Modes {
    std::vector<Ball> frequencies;
    Matrix factors;  // of these functions, in this order, for each entry of exp(B t) a column
  };
  [[nodiscard]] std::optional<Modes> make_modes(Piece piece) const;
  [[nodiscard]] const std::optional<Modes>& modes(Piece piece) const;
  [[nodiscard]] Matrix in_closed_form(const Modes& modes, const Ball& t) const;
  [[nodiscard]] Matrix flow_at(Piece piece, const Ball& t) const;
  // The one that is kept nearest to the time, or a new one.
  [[nodiscard]] const Exponential& nearest(Piece piece, const Ball& t) const;
  [[nodiscard]] const Ball& norm(Piece piece) const;
  // The largest number in the units of w.
  [[nodiscard]] Ball size_of(const Vector& w) const;
  // M B, of one machine or all; row n + i without the mass i of x_i'' where it moves.
  template <class S>
  [[nodiscard]] model::MatrixX<S> forces(const model::FrictionOscillator<S>& oscillator, Piece piece) const;
  // What times w is the force on a mass but for friction, as a column: of the mass that rubs -r.
  template <class S>
  [[nodiscard]] model::VectorX<S> forces_on(const model::FrictionOscillator<S>& oscillator,
                                            Eigen::Index mass) const;
  // Where w has cos k theta, and after it sin k theta.
  [[nodiscard]] Eigen::Index row_of_cosine(int multiple) const {
    return 2 * n_ + 1 + 2 * (std::ranges::find(multiples_, multiple) - multiples_.begin());
  }
  template <class M>
  [[nodiscard]] M moved(Piece piece, const Ball& h, M X) const;
  [[nodiscard]] Watch make_watch(Piece piece, bool reversed) const;

  model::FrictionOscillator<Ball> oscillator_;
  std::vector<int> multiples_;
  Eigen::Index n_, size_;
  Vector r_, units_;
  mutable std::map<Piece, Matrix> drifts_;
  mutable std::map<Piece, InData<Matrix>> drifts_in_data_;
  mutable std::map<Piece, std::optional<Modes>> modes_;
  mutable std::map<Piece, Ball> norms_;  // of these, in the units
  mutable std::map<Piece, std::vector<Exponential>> flows_;
  mutable std::map<Piece, std::vector<OverTime>> flows_over_times_;
  mutable std::map<std::pair<Piece, bool>, Watch> watches_;
  std::optional<OscillatorInData> machines_;
};

}  // namespace stickslip::numeric::machines
