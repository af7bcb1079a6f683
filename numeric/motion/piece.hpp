// A function on a subinterval of a phase, seen from one end of the phase and perhaps divided by the distance
// to that end: what infimum.hpp bounds from below.
#pragma once

#include "numeric/motion/course.hpp"

namespace stickslip::numeric::motion::pieces {

// A function and its first two derivatives at a point.
template <class S>
struct Taylor {
  S value, slope, curvature;
};

// The time s counts from that end of the phase.
struct Side {
  const Course * g;
  bool from_end;
};

// g/w on [a, b] of a side, w = s when weighted and 1 otherwise; `third` bounds the third derivative of g/w.
// For g(0) = 0: g(s)/s is the mean of g'(s x) over 0 < x < 1, so its n-th derivative is the mean of
// x^n g^(n+1)(s x), at most max |g^(n+1)|/(n+1), and g^(n+1)(0)/(n+1) at s = 0.
struct Piece {
  const Side * side;
  bool weighted;
  double a, b;
  Ball third;

  // g/w and its first two derivatives at s.
  [[nodiscard]] Taylor<Ball> at(double s) const;
  // The same in floating point: only a guess.
  [[nodiscard]] Taylor<double> guess_at(double s) const;
  // A guess of where the piece is smallest near s, within [low, high].
  [[nodiscard]] double descend(double s, double low, double high) const;
};

// Not less than the distance of any x in [a, b] from c in [a, b], whatever was rounded in finding c.
[[nodiscard]] double reach(double a, double c, double b);

// A guess of where the piece is smallest.
struct Guess {
  double value, s;
};
[[nodiscard]] Guess sampled_minimum(const Piece& piece);

}  // namespace stickslip::numeric::motion::pieces
