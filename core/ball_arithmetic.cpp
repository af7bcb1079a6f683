#include "core/ball_arithmetic.hpp"

#include "core/fmpq.hpp"

namespace stickslip {

constinit thread_local long WorkingPrecision::bits_ = 128;

WorkingPrecision::WorkingPrecision(long bits) : previous_(bits_) {
  bits_ = bits;
}
WorkingPrecision::~WorkingPrecision() {
  bits_ = previous_;
}

Ball::Ball(const Rational& value) : Ball() {
  arb_set_fmpq(value_, Fmpq(value).raw(), WorkingPrecision::bits());
}

Ball Ball::from_interval(const Rational& lower, const Rational& upper) {
  return hull(Ball(lower), Ball(upper));
}

Ball Ball::hull(const Ball& a, const Ball& b) {
  Ball result;
  arb_union(result.value_, a.value_, b.value_, WorkingPrecision::bits());
  return result;
}

Ball Ball::pi() {
  Ball result;
  arb_const_pi(result.value_, WorkingPrecision::bits());
  return result;
}

bool Ball::contains(const Rational& q) const {
  return arb_contains_fmpq(value_, Fmpq(q).raw()) != 0;
}

Ball Ball::midpoint() const {
  Ball result;
  arb_get_mid_arb(result.value_, value_);
  return result;
}

Ball Ball::radius() const {
  Ball result;
  arb_get_rad_arb(result.value_, value_);
  return result;
}

Ball Ball::lower() const {
  Ball result;
  arb_get_lbound_arf(arb_midref(result.value_), value_, WorkingPrecision::bits());
  return result;
}

Ball Ball::upper() const {
  Ball result;
  arb_get_ubound_arf(arb_midref(result.value_), value_, WorkingPrecision::bits());
  return result;
}

double Ball::approximate() const {
  return arf_get_d(arb_midref(value_), ARF_RND_NEAR);
}

}  // namespace stickslip
