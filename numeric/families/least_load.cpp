#include "numeric/families/least_load.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "numeric/motion/infimum.hpp"

namespace stickslip::numeric::families {

using namespace motion;

namespace {

// -x2' on the slip for another C: +1 if it is positive between the ends, -1 if it is negative somewhere, else
// 0.
int moves_down(const model::Wave<Ball>& zdot2, const Ball& tau, const Ball& C) {
  model::Wave<Ball> g = affine<Ball>(Ball(-1), zdot2, Ball(0));
  g.harmonics[2].b = C;
  const Ball least = weighted_infimum(g, tau, {.start = true, .end = true}).value;
  return least.is_positive() ? 1 : least.is_negative() ? -1 : 0;
}

Ball larger(const Ball& a, const Ball& b) {
  const Ball gap = a - b;
  return gap.is_positive() ? a : gap.is_negative() ? b : Ball::hull(a, b);
}

}  // namespace

LeastLoad least_load(const Motion& motion, const Ball& ur, int digits) {
  if (motion.phases.empty() || motion.phases.front().kind != PhaseKind::slip) {
    throw InternalError("a motion without a slip to begin with has no least load");
  }
  const model::Oscillator<Ball>& o = motion.oscillator;
  const Ball& tau = motion.phases.front().duration;
  const model::Wave<Ball> zdot2 = waves(motion, 0).zdot2;
  const Ball B = zdot2.harmonics[2].a;
  const double C = -zdot2.harmonics[2].b.approximate();
  Rational below(-1), above(1);
  const auto side = [&](const Rational& at) { return moves_down(zdot2, tau, Ball(at)); };
  for (int i = 0; i < 64 && side(above) != 1; ++i) {
    above *= 2;
  }
  for (int i = 0; i < 64 && side(below) != -1; ++i) {
    below *= 2;
  }
  if (side(above) != 1 || side(below) != -1) {
    throw InternalError("no load keeps the slip going, or every load does");
  }
  Rational width(std::max(1.0, std::abs(C)));
  for (int i = 0; i < digits; ++i) {
    width /= 10;
  }
  while (above - below > width) {
    const Rational middle = (above + below) / 2;
    const int decided = side(middle);
    if (decided == 0) {
      break;
    }
    (decided == 1 ? above : below) = middle;
  }
  LeastLoad result;
  result.speed_push = Ball::hull(Ball(below), Ball(above));
  result.friction_push = o.data.eta * ur / o.data.omega;
  const Ball push = larger(result.speed_push, result.friction_push);
  result.p = abs(o.data.p / (o.Q(1) * o.data.omega)) * sqrt(B * B + push * push);
  return result;
}

}  // namespace stickslip::numeric::families
