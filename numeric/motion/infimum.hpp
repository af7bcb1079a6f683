// The least value of a function of time over a phase, and what bounds it from below.
#pragma once

#include <array>
#include <optional>

#include "model/waves.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::motion {

// A function of time over a phase, as what bounds it from below needs it.

class Course {
 public:
  virtual ~Course() = default;
  // g, g', g'', g''' at the time s.
  [[nodiscard]] virtual std::array<Ball, 4> at(double s) const = 0;
  // The same in floating point: only a guess.
  [[nodiscard]] virtual std::array<double, 4> guess_at(double s) const = 0;
  // g/s and its first two derivatives at s > 0, where g(0) = 0 for each member of g: those that know how g
  // begins need not divide a wide ball by a small s.
  [[nodiscard]] virtual std::array<Ball, 3> quotient_at(double s) const;
};

// Bounds of |g'''| and |g''''| over the whole phase.
struct DerivativeBounds {
  Ball third, fourth;
};

// A wave, at all times.
class WaveCourse : public Course {
 public:
  explicit WaveCourse(const model::Wave<Ball>& g);
  [[nodiscard]] std::array<Ball, 4> at(double s) const override;
  [[nodiscard]] std::array<double, 4> guess_at(double s) const override;
  [[nodiscard]] DerivativeBounds bounds() const;  // at all times, reversed or not

 private:
  model::Wave<Ball> g_;
  model::Wave<double> guess_;
};

// The infimum over a whole closed phase of a function g, and of g divided by the distance to those ends where
// g vanishes by construction.
//
// With w(t) = min(1, t if g(0) = 0, T - t if g(T) = 0), 0 <= t <= T, the weighted infimum is
//   inf over 0 < t < T of g(t)/w(t),
// the largest m with g >= m w on the phase. At an end that g touches the quotient tends to the one-sided
// derivative there, so m > 0 means: g > 0 on the phase without the touched ends, and g leaves zero there with
// nonzero speed. Without touched ends m is the infimum of g on the closed phase. Time is dimensionless, hence
// m has the unit of g.

// At which ends of [0, T] g is known to be exactly zero, as a premise.
struct Touches {
  bool start = false;
  bool end = false;
};

struct Infimum {
  Ball value;  // contains the weighted infimum, for all members of g and of T
  Ball time;   // contains a time in [0, T] at which the quotient (its limit at a touched end) lies in `value`
  Ball start;  // g(0) and g(T), as far as g tells: a touched end whose ball excludes zero is none
  Ball end;
};

// Of g on [0, T], by itself and as a function of the time that is left, with bounds for both. Assumes T > 0
// for all members, and g zero at the touched ends. Returns an unbounded value when T or g is not finite or T
// is too wide a ball to be halved.
//
// Not sampled: the phase is covered by subintervals, on each a second-order Taylor form with a bound of the
// third derivative bounds g/w from below, and the places that come near the infimum are narrowed down until
// they are convex, concave or monotone, where the infimum is known.
[[nodiscard]] Infimum weighted_infimum(const Course& g, const Course& reversed,
                                       const DerivativeBounds& bounds, const Ball& T, Touches touches);
[[nodiscard]] Infimum weighted_infimum(const model::Wave<Ball>& g, const Ball& T, Touches touches);

// A time strictly inside (0, T) and the negative ball g(time); nothing when none was found near `near`.
struct Violation {
  Ball time;   // exact
  Ball value;  // negative
};
[[nodiscard]] std::optional<Violation> violation(const Course& g, const Ball& T, const Ball& near);

}  // namespace stickslip::numeric::motion
