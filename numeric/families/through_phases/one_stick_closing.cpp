#include <cmath>

#include "numeric/families/through_phases/one_stick_search.hpp"

namespace stickslip::numeric::families {

Ball angle(const std::pair<Ball, Ball>& cos_sin, const Ball& later) {
  Ball phi;
  arb_atan2(phi.raw(), cos_sin.second.raw(), cos_sin.first.raw(), WorkingPrecision::bits());
  phi += later;
  const Ball turn = Ball(2) * Ball::pi();
  return phi - turn * Ball(std::floor((phi / turn).approximate() + 0.5));
}

template struct OneStick<1, Datum::friction>;
template struct LinearEliminant<OneStick<1, Datum::friction>>;
template struct OneStick<3, Datum::friction>;
template struct LinearEliminant<OneStick<3, Datum::friction>>;

}  // namespace stickslip::numeric::families
