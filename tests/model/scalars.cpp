// The same template gives the same number over double and balls.
#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "model/flows.hpp"
#include "numeric/scalars/scalars.hpp"

using namespace stickslip;
using namespace stickslip::numeric::scalars;
using namespace stickslip::model;

namespace {

// The second phase of a motion that uses every formula of the model once.
template <class S>
Vector4<S> a_motion(const Parameters<S>& a, const S& phi, const S& t) {
  const Modes<S> m = modes<S>(a.chi, a.eta);
  const Vector2<S> q = Q(a, m);
  const Vector4<S> start = stack<S>(d0<S>(a.chi, a.us), q);
  const Vector4<S> slipped = slip_flow<S>(m, q, a.omega, phi, start, t);
  const Vector4<S> overshot =
      overshoot_flow<S>(m, q, d0<S>(a.chi, a.us), a.omega, S(a.omega * t + phi), slipped, t);
  return stick_flow<S>(a.chi, overshot, t);
}

template <class S, class Convert>
Vector4<S> the_motion(Convert convert) {
  const auto c = [&](const char * text) { return convert(parse_rational(text)); };
  return a_motion<S>({c("0.5"), c("3.8"), c("0.02"), c("1"), c("0.6"), c("0.05")}, c("0.7"), c("1.3"));
}

}  // namespace

TEST_CASE("double and ball agree to their precision") {
  const Vector4<double> doubles = the_motion<double>([](const Rational& q) { return q.get_d(); });
  const WorkingPrecision precision(400);
  const Vector4<Ball> balls = the_motion<Ball>([](const Rational& q) { return Ball(q); });
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK((abs(balls(i) - Ball(doubles(i))) - Ball(1e-13)).is_negative());
    CHECK((balls(i).radius() - Ball(parse_rational("1e-110"))).is_negative());
  }
}
