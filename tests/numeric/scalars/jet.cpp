// Derivatives by jets against difference quotients and against each other over different scalars.
#include "numeric/scalars/jet.hpp"

#include <doctest/doctest.h>

#include "core/decimal.hpp"
#include "model/scalar_traits.hpp"
#include "numeric/zeros/krawczyk.hpp"

using namespace stickslip;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::zeros;

namespace {

// Uses every operation of a jet.
template <class T>
T everything(const T& x, const T& y) {
  using model::sinc;
  using std::cos;
  using std::sin;
  using std::sqrt;
  T sum = T(sin(x)) * T(cos(y)) + T(sqrt(T(x + y))) / (T(2) + x * y);
  sum += T(sinc(T(x - y)));
  sum -= -y / x;
  sum *= x;
  sum /= T(3) + y;
  return +sum;
}

struct Everything {
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& v) const {
    return {everything(v(0), v(1)), everything(v(1), T(v(0) * v(1)))};
  }
};

}  // namespace

TEST_CASE("a jet's partials are the limits of difference quotients") {
  const Eigen::Vector2d at(0.7, 1.9);
  const auto [value, slope] = linearise<double, 2>(Everything{}, at);
  const double h = 1e-5;
  for (int j = 0; j < 2; ++j) {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    step(j) = h;
    const Eigen::Vector2d ahead = Everything{}(Eigen::Vector2d(at + step));
    const Eigen::Vector2d behind = Everything{}(Eigen::Vector2d(at - step));
    const Eigen::Vector2d quotient = (ahead - behind) / (2 * h);
    for (int i = 0; i < 2; ++i) {
      CHECK(slope(i, j) == doctest::Approx(quotient(i)).epsilon(1e-8));
    }
  }
  CHECK(value(0) == doctest::Approx(everything(0.7, 1.9)));
}

TEST_CASE("over balls a jet contains value and slope at every member") {
  const Box<2> box(Ball::from_interval(parse_rational("0.6"), parse_rational("0.8")),
                   Ball::from_interval(parse_rational("1.8"), parse_rational("2")));
  const auto [value, slope] = linearise<Ball, 2>(Everything{}, box);
  for (const double x : {0.61, 0.7, 0.79}) {
    for (const double y : {1.81, 1.9, 1.99}) {
      const auto [v, s] = linearise<Ball, 2>(Everything{}, Box<2>(Ball(x), Ball(y)));
      for (int i = 0; i < 2; ++i) {
        CHECK(value(i).contains(v(i)));
        CHECK(slope(i, 0).contains(s(i, 0)));
        CHECK(slope(i, 1).contains(s(i, 1)));
      }
    }
  }
}

TEST_CASE("sinc and its slope over double and balls, near and at zero") {
  const WorkingPrecision precision(200);
  for (const char * text : {"0", "1e-30", "-0.001", "0.3", "0.49", "0.51", "-2", "40"}) {
    CAPTURE(text);
    const Rational x = parse_rational(text);
    const Ball value = sinc(Ball(x));
    const Ball slope = sinc_slope(Ball(x));
    CHECK((abs(value - Ball(sinc(x.get_d()))) - Ball(1e-15)).is_negative());
    CHECK((abs(slope - Ball(sinc_slope(x.get_d()))) - Ball(1e-13)).is_negative());
    CHECK((slope.radius() - Ball(parse_rational("1e-50"))).is_negative());
    if (x != 0) {
      CHECK(slope.overlaps((cos(Ball(x)) - value) / Ball(x)));
    }
  }
  for (const double radius : {0.1, 0.4, 0.6, 3.0}) {
    const Ball wide = Ball::hull(Ball(-radius), Ball(radius));
    CHECK(sinc_slope(wide).contains(sinc_slope(Ball(radius))));
    CHECK(sinc_slope(wide).contains(sinc_slope(Ball(-radius / 2))));
    CHECK(sinc_slope(wide).is_finite());
  }
}
