// What ends a phase of a machine, as a function of the time, for motion/infimum.hpp.
#pragma once

#include <vector>

#include "numeric/machines/linear_phases.hpp"
#include "numeric/motion/course.hpp"

namespace stickslip::numeric::machines {

// f = row exp(B s) w of LinearPhases::watch, s from 0 to a little past T: on each of equal stretches a Taylor
// polynomial with a bound of what that leaves out.
class Watched {
 public:
  // From w where the phase begins; `reversed`: from w where it ends, against the time. The phases have to
  // live as long.
  Watched(const LinearPhases& phases, Piece piece, const Vector& w, const Ball& T, bool reversed);

  // f, f', f'', f''' at s; not finite outside.
  [[nodiscard]] std::array<Ball, 4> at(double s) const;
  [[nodiscard]] std::array<double, 4> guess_at(double s) const;
  // Of |f'''| and |f''''| over [0, T].
  [[nodiscard]] motion::DerivativeBounds bounds() const;

 private:
  struct Stretch {
    Vector w;                 // at its beginning
    std::vector<Ball> terms;  // the Taylor coefficients there
    std::vector<double> guess;
    std::array<Ball, 5> rest;  // what they leave out of the function and its derivatives is not more
  };
  [[nodiscard]] const Stretch& stretch(std::size_t k) const;
  [[nodiscard]] std::size_t stretch_of(double s) const;

  const LinearPhases::Watch& watch_;
  const Matrix& drift_;
  bool reversed_;
  std::size_t count_ = 1;
  bool covers_;  // [0, T]
  mutable std::vector<Stretch> stretches_;
};

// sign f + offset.
class AffineCourse : public motion::Course {
 public:
  AffineCourse(const Watched& f, int sign, const Ball& offset) : f_(f), sign_(sign), offset_(offset) {}
  [[nodiscard]] std::array<Ball, 4> at(double s) const override;
  [[nodiscard]] std::array<double, 4> guess_at(double s) const override;

 private:
  const Watched& f_;
  int sign_;
  Ball offset_;
};

}  // namespace stickslip::numeric::machines
