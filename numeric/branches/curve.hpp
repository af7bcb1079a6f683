// A branch of closed motions: a curve in the space of the unknowns of its closing conditions and one free
// parameter of the data, followed without a gap.
//
// The curve is covered by cells. On a cell one coordinate drives: the free parameter, or next to a fold one
// of the unknowns, and for each value that it takes there is exactly one closed motion in a box of the other
// coordinates, by Krawczyk's test over the cell (zeros/parametric.hpp). So the cell is a smooth arc. A cell
// continues the one before it if a motion that is proved on both, in boxes where each is the only one, is the
// same; two different branches cannot be joined in this way.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/rational.hpp"
#include "numeric/branches/state.hpp"
#include "numeric/families/family.hpp"
#include "numeric/machine_along.hpp"
#include "numeric/motion/closing.hpp"

namespace stickslip::numeric::branches {

using families::Growth;

// Units in which the unknown at `place` has the size 1 and the given sign: in its place there stands e, the
// reciprocal of its size, and the growing ones and us, V, p and ur are multiplied by that.
struct Units {
  int place = 0;
  int sign = 1;
  std::vector<int> growing;

  friend bool operator==(const Units&, const Units&) = default;
};

// Closing conditions with one free parameter, and its interval: the parameter stands at `place` among the
// data, or is a value of a machine in SI units, on which they depend.
struct Curve {
  motion::Closing equations;
  zeros::Vector data;  // whatever stands at `place`
  int place = 0;
  Rational from, to;
  // Motions with an unknown of more than this size are followed no further as they grow, unless the branch is
  // proved to leave for infinity there, in one of these ways.
  double far = HUGE_VAL;
  int angle = -1;  // the place of an unknown that counts modulo 2 pi, or none
  std::vector<Growth> growths = {};
  std::optional<Units> units = {};  // of the unknowns and the motions, where these are not their own
  std::optional<MachineAlong> machine = {};

  // In the equations' order, at that value of the free parameter.
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> data_at(const T& value) const {
    if (machine) {
      return equations.parameters<T>(machine->at<T, Ball>(value));
    }
    zeros::VectorOf<T> p = data.template cast<T>();
    p(place) = value;
    return p;
  }
};

inline constexpr int by_parameter = -1;

// The closing conditions as equations for all coordinates but the driver, the one parameter of them, for
// zeros/parametric.hpp. Where an unknown drives, the free parameter has its place among the unknowns.
struct Driven {
  const Curve * curve = nullptr;
  int driver = by_parameter;

  template <class T>
  struct Split {
    zeros::VectorOf<T> x, p;
  };
  template <class T>
  [[nodiscard]] Split<T> split(const zeros::VectorOf<T>& y, const zeros::VectorOf<T>& q) const {
    Split<T> s{y, curve->data_at<T>(value<T>(y, q))};
    if (driver != by_parameter) {
      s.x(driver) = q(0);
    }
    return s;
  }
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& y, const zeros::VectorOf<T>& q) const {
    const Split<T> s = split<T>(y, q);
    return curve->equations.template closing<T>(s.x, s.p);
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& y, const zeros::VectorOf<T>& q) const {
    const Split<T> s = split<T>(y, q);
    return curve->equations.template motion<T>(s.x, s.p);
  }
  // The free parameter.
  template <class T>
  [[nodiscard]] T value(const zeros::VectorOf<T>& y, const zeros::VectorOf<T>& q) const {
    return driver == by_parameter ? q(0) : y(driver);
  }
  // By which the lengths of the motion are multiplied.
  template <class T>
  [[nodiscard]] T unit(const zeros::VectorOf<T>& y, const zeros::VectorOf<T>& q) const {
    return curve->units ? split<T>(y, q).x(curve->units->place) : T(1);
  }
};

// Contains exactly one closed motion: its unknowns, in their own units, and the value of the free parameter.
struct Point {
  zeros::Vector x;
  Ball value;
};

// Whether the predicate holds for the point with its angle turned by some number of full turns that matters.
template <class Predicate>
[[nodiscard]] bool for_some_turn(int angle, const Point& point, const Predicate& predicate) {
  for (int turn = angle < 0 ? 0 : -2; turn <= (angle < 0 ? 0 : 2); ++turn) {
    Point turned = point;
    if (turn != 0) {
      turned.x(angle) += Ball(2 * turn) * Ball::pi();
    }
    if (predicate(turned)) {
      return true;
    }
  }
  return false;
}

struct Cell {
  int driver = by_parameter;
  Rational first, last;  // of the driver, in the direction of the branch: it rises or falls
  Ball range;            // from the one to the other: what the proof is over
  zeros::ParametricProof proof;
  std::shared_ptr<const Curve> in_units = {};  // the branch's curve in the cell's units, if it has any

  [[nodiscard]] const Curve& on(const Curve& branch) const { return in_units ? *in_units : branch; }
};

// From and to a motion's own units. Not finite where the unknown whose size is 1 may vanish, or be infinite.
[[nodiscard]] Point scaled_point(const Units& units, const Point& point);
[[nodiscard]] Point unscaled_point(const Units& units, const Point& point);

// The motion that (y, q) stand for, as Driven takes them.
[[nodiscard]] Point point_of(const Driven& f, const zeros::Vector& y, const zeros::Vector& q);

// A proposal for the unknowns at that value of the driver, to first order from the middle of the proof.
[[nodiscard]] zeros::Vector motion_near(const zeros::ParametricProof& proof, const Rational& value);

[[nodiscard]] Ball between(const Rational& a, const Rational& b);

// Whether the motion at the point is on the cell: proved, or not known.
[[nodiscard]] bool is_on(const Cell& cell, const Point& point);

// False: no motion at the point is on the cell.
[[nodiscard]] bool may_meet(const Cell& cell, const Point& point);

struct Path {
  std::vector<Cell> cells;
  End end = End::stopped;
  std::string reason;
  Point last;                      // of those that are not in other units
  std::optional<Ball> limit = {};  // of the free parameter, where the motion grows beyond all bounds
  // Of a closed branch: so many cells go round it once, the last of them over this value of its driver, where
  // the branch began. One more is there for what has to overlap.
  std::size_t once_round = 0;
  Ball back;
};

// The proved motion at that value of the free parameter near the guess; its existence is undecided where no
// box passes.
struct ProvedPoint {
  Verdict verdict;
  Point point;
};
[[nodiscard]] ProvedPoint prove_at(const Curve& curve, const Rational& value, const zeros::Vector& guess);

// Follows the branch from a proved motion at that value of the free parameter, the free parameter rising
// (direction 1) or falling (-1) at first, until it leaves the interval, a phase lasts a negative time, the
// branch is back, or no step can be proved. The last cell may reach beyond the interval.
[[nodiscard]] Path follow(const Curve& curve, const Rational& value, const Point& start, int direction);

// Where a branch leaves for infinity (infinity.cpp).

// From a proved motion on: cells in which e falls to 0, the last of them to 0 itself, and the limit of the
// free parameter there.
struct WayToInfinity {
  std::vector<Cell> cells;
  Ball limit;
};

// If the branch goes on from the proved motion so that one of its lengths grows without an end, all phases
// lasting: then there is one motion for each size of this length. Nothing where that is not proved, or where
// that length may not grow along the cell, whose last motion it is.
[[nodiscard]] std::optional<WayToInfinity> way_to_infinity(const Curve& curve, const Cell& cell,
                                                           const Point& large);

// The same arcs the other way round.
[[nodiscard]] std::vector<Cell> reversed(std::vector<Cell> cells);

}  // namespace stickslip::numeric::branches
