// What the friction law asks of a phase of a motion, or of all motions of a set, decided at all times of it.
#pragma once

#include <optional>
#include <vector>

#include "numeric/machines/phases/linear_phases.hpp"
#include "numeric/motion/conditions.hpp"
#include "numeric/motion/infimum.hpp"
#include "numeric/scalars/hardware_ball.hpp"

namespace stickslip::numeric::machines {

// With so many bits conditions are looked at first; there balls in hardware take the place of Arb's.
inline constexpr long few_bits = 64;

// What ends a phase of a machine, as a function of the time, for motion/infimum.hpp.

// f, r on a stick and x_j' else, s from 0 to a little past T: on each of some stretches a Taylor polynomial.
// They are equal, with f = row exp(B s) w of LinearPhases::watch and a bound of what the polynomial leaves
// out; or, on a smooth law of friction, the steps of a SmoothPhase.
class Watched {
 public:
  // From w where the phase begins; `reversed`: from w where it ends, against the time. The phases have to
  // live as long.
  Watched(const LinearPhases& phases, Piece piece, const InData<Matrix>& w, const Ball& T, bool reversed);

  // The derivative of that order of f + offset, and the next three, at s; not finite outside.
  [[nodiscard]] std::array<Ball, 4> at(const Ball& s, std::size_t derivative = 0,
                                       const InData<Ball>& offset = InData<Ball>(Ball(0))) const;
  [[nodiscard]] std::array<double, 4> guess_at(double s, std::size_t derivative = 0) const;
  // Of (f - f(0))/s, f that derivative, itself and its first two derivatives; nothing beyond the first
  // stretch and on a smooth law.
  [[nodiscard]] std::optional<std::array<Ball, 3>> quotient_at(double s, std::size_t derivative) const;
  // Of its third and fourth over [0, T].
  [[nodiscard]] motion::DerivativeBounds bounds(std::size_t derivative = 0) const;
  // Of which there are bounds.
  static constexpr std::size_t most_derivatives = 1;

 private:
  struct Stretch {
    double start, length;                         // exact
    InData<Matrix> w;                             // at its beginning, where it is linear
    InData<Vector> terms;                         // the Taylor coefficients there
    model::VectorX<scalars::HardwareBall> quick;  // of one motion, at few bits
    Eigen::VectorXd most;                         // no less than the size of any of these
    Eigen::VectorXd guess;
    std::array<double, 6> rest;  // what they leave out of the function and its derivatives is not more
  };
  // With its coefficients.
  [[nodiscard]] const Stretch& stretch(std::size_t k) const;
  void finish(Stretch& stretch) const;
  [[nodiscard]] std::size_t stretch_of(double s) const;

  template <class S>
  void follow(const model::VectorX<S>& w, const Ball& T);
  [[nodiscard]] InData<Vector> terms_at(const InData<Matrix>& w) const;

  const LinearPhases::Watch * watch_ = nullptr;  // nothing on a smooth law, where all stretches are there
  const LinearPhases& phases_;
  Piece piece_;
  bool reversed_;
  std::size_t count_ = 1;
  bool covers_;  // [0, T]
  mutable std::vector<Stretch> stretches_;
};

// As a function of s, at the time origin + direction s: sign f + offset, or sign f'.
class AffineCourse : public motion::Course {
 public:
  struct View {
    std::size_t derivative = 0;
    double origin = 0;
    int direction = 1;
  };
  AffineCourse(const Watched& f, int sign, const InData<Ball>& offset)
      : AffineCourse(f, sign, offset, View{}) {}
  AffineCourse(const Watched& f, int sign, const InData<Ball>& offset, View view)
      : f_(f),
        sign_(sign),
        offset_(view.derivative == 0 ? offset * Ball(sign) : InData<Ball>(Ball(0))),
        view_(view) {}
  [[nodiscard]] std::array<Ball, 4> at(double s) const override;
  [[nodiscard]] std::array<double, 4> guess_at(double s) const override;
  [[nodiscard]] std::array<Ball, 3> quotient_at(double s) const override;

 private:
  template <class S>
  [[nodiscard]] std::array<S, 4> seen(std::array<S, 4> d) const;

  const Watched& f_;
  int sign_;
  InData<Ball> offset_;  // sign (sign f + offset) = f + offset_
  View view_;
};

// What the friction law asks of a phase of a motion, or of all motions of a set.

struct JudgedPhase {
  // Its neighbours; nothing where only the part of the phase from, or until, some time inside it is meant.
  std::optional<Piece> before;
  Piece piece;
  std::optional<Piece> after;
  Ball start, duration;       // in the time of the motion
  InData<Matrix> begin, end;  // w at its ends
};

// Appends what keeps the phase from ending early and what lets it begin and end as it does, decided for each
// motion that begins and ends in these balls, under the premise that it reaches the belt, the end of the
// law's piece or r = ur at the end that its neighbour stands for. `exact`: the oscillator of the phases.
void judge_phase(std::vector<motion::Condition>& list, const LinearPhases& phases,
                 const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase);

}  // namespace stickslip::numeric::machines
