#include "numeric/branches/tubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"

namespace stickslip::numeric::branches {

using namespace zeros;
using families::Bounds;

namespace {

// As shares of a cell's length and of the radii of the box in which its motions are the only ones.
constexpr double overlap = 0.25;
constexpr double wider = 3;
// As shares of the sizes of the unknowns: tubes around arcs that are short, or do not depend on the
// parameter, could be too narrow for doubles.
constexpr std::array least_radii{0x1p-12, 0x1p-20, 0x1p-30};
// As a share of the interval.
constexpr double rounding = 0x1p-30;

// All of it lies in the ball.
Bounds within(const Ball& x) {
  return {arf_get_d(arb_midref(x.lower().raw()), ARF_RND_CEIL),
          arf_get_d(arb_midref(x.upper().raw()), ARF_RND_FLOOR)};
}

bool contains(const Bounds& outer, const Bounds& inner) {
  return outer.first <= inner.first && inner.second <= outer.second;
}

// The cell's arc, longer where it has neighbours, and in a wider box where that holds no more motions.
// Nothing when it cannot be proved to be the same arc.
std::optional<std::pair<Ball, Vector>> longer(const Curve& curve, const Cell& cell, bool before, bool after) {
  const Rational more = (cell.last - cell.first) * Rational(overlap);
  const auto at_end = [&](const Rational& value) {
    return cell.driver == by_parameter && (value == curve.from || value == curve.to);
  };
  Rational first = before || at_end(cell.first) ? Rational(cell.first - more) : cell.first;
  Rational last = after || at_end(cell.last) ? Rational(cell.last + more) : cell.last;
  if (cell.driver == by_parameter) {
    // A little beyond the interval, for what is rounded.
    const Rational little = (curve.to - curve.from) * Rational(rounding);
    first = std::clamp(first, Rational(curve.from - little), Rational(curve.to + little));
    last = std::clamp(last, Rational(curve.from - little), Rational(curve.to + little));
  }
  const Driven f{&curve, cell.driver};
  const Vector Q = Vector::Constant(1, between(first, last));
  const ParametricProof proof = prove_over_parameters(f, Q, cell.proof.at_middle);
  // The middle of the longer arc is on the cell: by continuation all that they share is the same.
  if (proof.verdict.truth != Truth::proved || !cell.range.contains(proof.p0(0))) {
    return std::nullopt;
  }
  for (int i = 0; i < proof.at_middle.size(); ++i) {
    if (!cell.proof.unique(i).contains(proof.at_middle(i))) {
      return std::nullopt;
    }
  }
  for (const double least : least_radii) {
    Vector wide = proof.unique;
    for (Ball& side : wide) {
      const double size = std::max(1.0, std::abs(side.approximate()));
      const Ball radius = side.radius() * Ball(wider) + Ball(least * size);
      side = side.midpoint() + Ball::hull(-radius, radius);
    }
    if (holds_one_zero(f, proof, wide)) {
      return std::pair(Q(0), wide);
    }
  }
  return std::pair(Q(0), proof.unique);
}

}  // namespace

Tubes::Tubes(const Curve& curve, const std::vector<Cell>& cells, int angle) : angle_(angle) {
  tubes_ = parallel_map(cells.size(), [&](std::size_t k) {
    const Cell& cell = cells[k];
    const auto better = longer(curve, cell, k > 0, k + 1 < cells.size());
    Tube tube{{}, cell.driver, within(better ? better->first : cell.range)};
    for (const Ball& side : better ? better->second : cell.proof.unique) {
      tube.sides.push_back(within(side));
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
    return hold_turned(x, parameter);
  }
  for (int k = -2; k <= 2; ++k) {
    std::vector<Bounds> turned = x;
    Bounds& side = turned[static_cast<std::size_t>(angle_)];
    // The turn is a little less or more than 2 pi.
    side = {side.first + k * turn - 0x1p-40, side.second + k * turn + 0x1p-40};
    if (hold_turned(turned, parameter)) {
      return true;
    }
  }
  return false;
}

// Along each branch neighbouring tubes with the same driver may hold the bounds together.
bool Tubes::hold_turned(const std::vector<Bounds>& x, const Bounds& parameter) const {
  const Tube * before = nullptr;
  Bounds held{};
  for (const Tube& tube : tubes_) {
    const auto place = static_cast<std::size_t>(tube.driver);
    const Bounds& driver = tube.driver == by_parameter ? parameter : x[place];
    bool here = tube.range.first <= driver.second && driver.first <= tube.range.second;
    for (std::size_t i = 0; here && i < x.size(); ++i) {
      here = contains(tube.sides[i], i == place ? parameter : x[i]);
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
    if (contains(held, driver)) {
      return true;
    }
  }
  return false;
}

}  // namespace stickslip::numeric::branches
