#include "numeric/scalars/exact.hpp"

#include <doctest/doctest.h>

#include "model/flows.hpp"

using namespace stickslip;
using namespace stickslip::numeric::scalars;

namespace {

bool equal(const Exact& a, const Exact& b) {
  return a.value() == b.value();
}

}  // namespace

TEST_CASE("what holds on the circle holds exactly at every point") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const ExactPoint point(seed);
    const Exact a = point.symbol("omega1") * point.symbol("t"), b = point.symbol("phi") / 2;
    CHECK(equal(sin(a) * sin(a) + cos(a) * cos(a), 1));
    CHECK(equal(sin(a + b), sin(a) * cos(b) + cos(a) * sin(b)));
    CHECK(equal(cos(-b), cos(b)));
    CHECK(equal(sin(2 * b), 2 * sin(b) * cos(b)));
    CHECK(equal(cos(a - a), 1));
    CHECK(equal(exp(a + b), exp(a) * exp(b)));
    CHECK(equal(exp(-b) * exp(b / 2) * exp(b / 2), 1));
    CHECK(equal(exp(a - a), 1));
  }
}

TEST_CASE("what does not hold fails at every point tried") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const ExactPoint point(seed);
    const Exact t = point.symbol("t"), a = point.symbol("omega1") * t, b = point.symbol("omega2") * t;
    CHECK_FALSE(equal(sin(a), cos(a)));
    CHECK_FALSE(equal(sin(a + b), sin(a) * cos(b) - cos(a) * sin(b)));
    CHECK_FALSE(equal(cos(a), cos(b)));
    CHECK_FALSE(equal(t, point.symbol("s")));
    CHECK_FALSE(equal(exp(a), exp(2 * a)));
    CHECK_FALSE(equal(exp(a), exp(b)));
    CHECK_FALSE(equal(exp(a), 1 + a));
    CHECK_FALSE(equal(point.symbol("pi"), Exact(Rational(22, 7))));
  }
}

TEST_CASE("multiples of pi are turns") {
  const ExactPoint point(3);
  const Exact pi = point.symbol("pi"), omega = point.symbol("omega");
  CHECK(equal(cos(pi), -1));
  CHECK(equal(sin(pi / 2), 1));
  CHECK(equal(sin(omega * (2 * pi / omega) + pi / 2), 1));
  CHECK_THROWS_AS((void)cos(pi / 3), NoExactValue);
}

TEST_CASE("what has no exact value says so, and nothing is divided by zero") {
  const ExactPoint point(5);
  const Exact t = point.symbol("t");
  CHECK_THROWS_AS((void)sin(t / 3), NoExactValue);
  CHECK_THROWS_AS((void)sin(cos(t)), NoExactValue);
  CHECK_THROWS_AS((void)sin(Exact(1)), NoExactValue);
  CHECK_THROWS_AS((void)exp(t / 3), NoExactValue);
  CHECK_THROWS_AS((void)exp(exp(t)), NoExactValue);
  CHECK_THROWS_AS((void)exp(Exact(1)), NoExactValue);
  CHECK_THROWS_AS((void)(t / (t - t)), ZeroDivision);
  CHECK(equal(sin(Exact(0)), 0));
}

TEST_CASE("it is a scalar of the model: H(t) H(-t) = I") {
  const ExactPoint point(7);
  const Exact omega1 = point.symbol("omega1"), omega2 = point.symbol("omega2"), t = point.symbol("t");
  const auto m = model::modes_of<Exact>(model::chi_from_frequencies<Exact>(omega1, omega2), omega1, omega2);
  const model::Matrix4<Exact> product = model::H<Exact>(m, t).lazyProduct(model::H<Exact>(m, -t));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      CHECK(equal(product(i, j), i == j ? 1 : 0));
    }
  }
}
