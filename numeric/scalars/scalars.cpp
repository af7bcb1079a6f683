#include "numeric/scalars/scalars.hpp"

#include <cln/float.h>
#include <cln/integer_io.h>
#include <cln/rational.h>
#include <cln/rational_io.h>

#include <cmath>
#include <numbers>

namespace stickslip::numeric::scalars {
namespace {

cln::float_format_t format_of(long bits) {
  return cln::float_format(static_cast<unsigned long>(static_cast<double>(bits) * 0.30103) + 1);
}

cln::cl_I to_cln(const mpz_class& value) {
  return cln::cl_I(value.get_str().c_str());
}

}  // namespace

cln::cl_R to_cln(const Rational& value, long bits) {
  return cln::cl_float(cln::cl_RA(to_cln(value.get_num()) / to_cln(value.get_den())), format_of(bits));
}

cln::cl_R to_cln(const Ball& ball) {
  fmpq_t exact;
  fmpq_init(exact);
  arf_get_fmpq(exact, arb_midref(ball.raw()));
  Rational value;
  fmpq_get_mpq(value.get_mpq_t(), exact);
  fmpq_clear(exact);
  return to_cln(value, WorkingPrecision::bits());
}

long bits_for(int digits) {
  return static_cast<long>(std::ceil(3.3219281 * digits)) + 16;
}

template <>
double scalar<double>(const Rational& value) {
  return Ball(value).approximate();  // to nearest; GMP's own conversion cuts off
}
template <>
cln::cl_R scalar<cln::cl_R>(const Rational& value) {
  return to_cln(value, WorkingPrecision::bits());
}
template <>
Ball scalar<Ball>(const Rational& value) {
  return Ball(value);
}
template <>
double pi<double>() {
  return std::numbers::pi;
}
template <>
cln::cl_R pi<cln::cl_R>() {
  return cln::pi(format_of(WorkingPrecision::bits()));
}
template <>
Ball pi<Ball>() {
  return Ball::pi();
}

}  // namespace stickslip::numeric::scalars
