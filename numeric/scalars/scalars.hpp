// The scalars that numbers are computed with besides double: CLN floats for guesses of any precision, Arb
// balls for proofs, and jets over either for derivatives.
#pragma once

#include <cln/real.h>
#include <cln/real_io.h>

#include <Eigen/Core>

#include "core/ball.hpp"
#include "core/rational.hpp"

namespace stickslip::numeric::scalars {

// A CLN float with at least `bits` bits of mantissa that rounds the value. Operations keep the precision of
// their float operands, so numbers made here compute at the precision that was asked for.
[[nodiscard]] cln::cl_R to_cln(const Rational& value, long bits);

// The midpoint of a finite ball as a CLN float of the working precision: to compare the two engines.
[[nodiscard]] cln::cl_R to_cln(const Ball& ball);

// The bits that `digits` significant digits need, with a few to spare.
[[nodiscard]] long bits_for(int digits);

// sum += a b and sum -= a b without a temporary.
inline void add_product(double& sum, double a, double b) {
  sum += a * b;
}
inline void subtract_product(double& sum, double a, double b) {
  sum -= a * b;
}

// An exact number and pi as scalars of one kind; balls and CLN floats take the working precision.
template <class S>
[[nodiscard]] S scalar(const Rational& value);
template <class S>
[[nodiscard]] S pi();

template <>
[[nodiscard]] double scalar<double>(const Rational& value);
template <>
[[nodiscard]] cln::cl_R scalar<cln::cl_R>(const Rational& value);
template <>
[[nodiscard]] Ball scalar<Ball>(const Rational& value);
template <>
[[nodiscard]] double pi<double>();
template <>
[[nodiscard]] cln::cl_R pi<cln::cl_R>();
template <>
[[nodiscard]] Ball pi<Ball>();

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <>
struct NumTraits<stickslip::Ball> : GenericNumTraits<stickslip::Ball> {
  using Real = stickslip::Ball;
  using NonInteger = stickslip::Ball;
  using Nested = stickslip::Ball;
  using Literal = stickslip::Ball;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 40,
    MulCost = 40
  };
};

template <>
struct NumTraits<cln::cl_R> : GenericNumTraits<cln::cl_R> {
  using Real = cln::cl_R;
  using NonInteger = cln::cl_R;
  using Nested = cln::cl_R;
  using Literal = cln::cl_R;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 50,
    MulCost = 100
  };
};

}  // namespace Eigen
