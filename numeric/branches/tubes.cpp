#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "numeric/branches/search.hpp"

namespace stickslip::numeric::branches {

using namespace zeros;
using families::Bounds;

namespace {

// As shares of a cell's length, tried in this order, and of the radii of the box in which its motions are the
// only ones.
constexpr std::array overlaps{0.25, 0x1p-8, 0.0};
constexpr std::array wider{3, 1};
// As shares of the sizes of the unknowns: tubes around arcs that are short, or do not depend on the
// parameter, could be too narrow for doubles.
constexpr std::array least_radii{0x1p-12, 0x1p-20, 0x1p-30};
// As a share of the interval.
constexpr double rounding = 0x1p-30;

bool covers(const Bounds& outer, const Bounds& inner) {
  return outer.first <= inner.first && inner.second <= outer.second;
}

// The arc of a cell made longer.
struct Longer {
  Ball range;  // of the driver
  Vector sides;
};

// Whether the arc of the proof, from its middle on the cell to that value of the driver, is on the cell or on
// its neighbour: both ends of what was added are. On a closed curve that could be the other way round it, if
// the neighbour came back to the cell's middle.
bool goes_on_with(const Driven& f, const ParametricProof& proof, const Rational& value,
                  const Cell& neighbour) {
  const Vector q = Vector::Constant(1, Ball(value));
  const ZeroProof<Eigen::Dynamic> end = prove_zero_at(f, q, motion_near(proof, value));
  return end.verdict.truth == Truth::proved && contains(proof.unique, end.box) &&
         is_on(neighbour, point_of(f, end.box, q)) &&
         !may_meet(neighbour, point_of(f, proof.at_middle, proof.p0));
}

// By that share of the cell's length where a neighbour goes on with it, and of the neighbour's where one
// coordinate drives both; a little beyond the interval, for what is rounded. In a wider box where that holds
// no more motions. Nothing when it cannot be proved to be the branch's own arc.
std::optional<Longer> longer(const Curve& curve, const Cell& cell, const Cell * before, const Cell * after,
                             double share) {
  const Rational little = (curve.to - curve.from) * Rational(rounding);
  const auto moved = [&](const Rational& end, const Rational& other, const Cell * neighbour) {
    if (cell.driver == by_parameter && (end == curve.from || end == curve.to)) {
      return end == curve.to ? Rational(end + little) : Rational(end - little);
    }
    if (neighbour == nullptr) {
      return end;
    }
    Rational length = abs(cell.last - cell.first);
    if (neighbour->driver == cell.driver && neighbour->in_units == cell.in_units) {
      length = std::min(length, Rational(abs(neighbour->last - neighbour->first)));
    }
    const Rational result = end + (end > other ? length : Rational(-length)) * Rational(share);
    return cell.driver == by_parameter ? std::clamp(result, curve.from, curve.to) : result;
  };
  const Rational first = moved(cell.first, cell.last, before);
  const Rational last = moved(cell.last, cell.first, after);
  const Driven f{&cell.on(curve), cell.driver};
  const ParametricProof proof =
      prove_over_parameters(f, Vector::Constant(1, between(first, last)), cell.proof.at_middle);
  // The middle of the longer arc is on the cell: by continuation all that they share is the same.
  if (proof.verdict.truth != Truth::proved || !cell.range.contains(proof.p0(0)) ||
      !contains(cell.proof.unique, proof.at_middle)) {
    return std::nullopt;
  }
  if ((before != nullptr && first != cell.first && !goes_on_with(f, proof, first, *before)) ||
      (after != nullptr && last != cell.last && !goes_on_with(f, proof, last, *after))) {
    return std::nullopt;
  }
  for (const int times : wider) {
    for (const double least : least_radii) {
      Vector wide = proof.unique;
      for (Ball& side : wide) {
        const double size = std::max(1.0, std::abs(side.approximate()));
        const Ball radius = side.radius() * Ball(times) + Ball(least * size);
        side = side.midpoint() + Ball::hull(-radius, radius);
      }
      if (holds_one_zero(f, proof, wide)) {
        return Longer{between(first, last), wide};
      }
    }
  }
  return Longer{between(first, last), proof.unique};
}

}  // namespace

Tubes::Tubes(const Curve& curve, const std::vector<Cell>& cells) : angle_(curve.angle) {
  tubes_ = parallel_map(cells.size(), [&](std::size_t k) {
    const Cell& cell = cells[k];
    Tube tube{{}, cell.driver, scalars::inner_ends(cell.range), cell.on(curve).units};
    Vector sides = cell.proof.unique;
    for (const double share : overlaps) {
      if (const auto better = longer(curve, cell, k > 0 ? &cells[k - 1] : nullptr,
                                     k + 1 < cells.size() ? &cells[k + 1] : nullptr, share)) {
        tube.range = scalars::inner_ends(better->range);
        sides = better->sides;
        break;
      }
    }
    for (const Ball& side : sides) {
      tube.sides.push_back(scalars::inner_ends(side));
    }
    return tube;
  });
}

bool Tubes::hold(const std::vector<Bounds>& x, const Bounds& parameter) const {
  constexpr double turn = 6.283185307179586;
  if (x.empty()) {
    return false;
  }
  if (angle_ < 0) {
    return hold(std::nullopt, x, parameter);
  }
  for (int k = -2; k <= 2; ++k) {
    std::vector<Bounds> turned = x;
    Bounds& side = turned[static_cast<std::size_t>(angle_)];
    // The turn is a little less or more than 2 pi.
    side = {side.first + k * turn - 0x1p-40, side.second + k * turn + 0x1p-40};
    if (hold(std::nullopt, turned, parameter)) {
      return true;
    }
  }
  return false;
}

// Along each branch neighbouring tubes with the same driver and units may hold the bounds together.
bool Tubes::hold(const std::optional<Units>& units, const std::vector<Bounds>& x,
                 const Bounds& parameter) const {
  const Tube * before = nullptr;
  Bounds held{};
  for (const Tube& tube : tubes_) {
    const auto place = static_cast<std::size_t>(tube.driver);
    const Bounds& driver = tube.driver == by_parameter ? parameter : x[place];
    bool here = tube.units == units && tube.range.first <= driver.second && driver.first <= tube.range.second;
    for (std::size_t i = 0; here && i < x.size(); ++i) {
      here = covers(tube.sides[i], i == place ? parameter : x[i]);
    }
    if (!here) {
      before = nullptr;
      continue;
    }
    const bool joins = before != nullptr && before->driver == tube.driver &&
                       tube.range.first <= held.second && held.first <= tube.range.second;
    held = joins ? Bounds{std::min(held.first, tube.range.first), std::max(held.second, tube.range.second)}
                 : tube.range;
    before = &tube;
    if (covers(held, driver)) {
      return true;
    }
  }
  return false;
}

}  // namespace stickslip::numeric::branches
