// Taylor coefficients against derivatives known in closed form.
#include "numeric/scalars/series.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "numeric/scalars/exact.hpp"

using namespace stickslip;
using namespace stickslip::numeric::scalars;

TEST_CASE("coefficients of products, quotients, sine and cosine are derivatives over factorials") {
  const double at = 0.7, w = 1.3;
  const auto t = Series<double>::variable(at, 4);
  const Series<double> s = sin(Series<double>(w) * t), quotient = s / (t * t + 1);
  double factor = 1;  // w^k / k!
  const double slopes[] = {std::sin(w * at), std::cos(w * at), -std::sin(w * at), -std::cos(w * at),
                           std::sin(w * at)};
  for (int k = 0; k < 5; ++k) {
    const auto i = static_cast<std::size_t>(k);
    CHECK(s[i] == doctest::Approx(factor * slopes[k]));
    CHECK((quotient * (t * t + 1))[i] == doctest::Approx(s[i]));
    CHECK((s * s + cos(Series<double>(w) * t) * cos(Series<double>(w) * t))[i] ==
          doctest::Approx(k == 0 ? 1 : 0));
    factor *= w / (k + 1);
  }
  // (t^4)'' = 12 t^2
  const Series<double> second = (t * t * t * t).derivative().derivative();
  CHECK(second.size() == 3);
  CHECK(second[0] == doctest::Approx(12 * at * at));
}

TEST_CASE("what does not depend on the variable stays a constant") {
  const Series<double> c = sin(Series<double>(2)) / 3 - 1;
  CHECK(c.size() == 1);
  CHECK(c.derivative().size() == 1);
  CHECK(is_zero(c.derivative()));
  CHECK_FALSE(is_zero(Series<double>::variable(0, 1)));
  CHECK(Series<double>::variable(5, 0).size() == 1);
}

TEST_CASE("exactly: (sin w t)'' = -w² sin w t, over balls the slope is contained for every member") {
  const ExactPoint point(3);
  const Exact w = point.symbol("omega");
  const auto t = Series<Exact>::variable(point.symbol("t"), 2);
  const Series<Exact> s = sin(Series<Exact>(w) * t);
  CHECK(s.derivative().derivative()[0].value() == (Exact(-1) * w * w * s[0]).value());
  const Ball box = Ball::from_interval(parse_rational("0.6"), parse_rational("0.8"));
  const Series<Ball> slopes =
      (sin(Series<Ball>::variable(box, 1)) / Series<Ball>::variable(box, 1)).derivative();
  const Ball at(parse_rational("0.75"));
  CHECK(slopes[0].contains(cos(at) / at - sin(at) / (at * at)));
}
