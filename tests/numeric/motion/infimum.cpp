// The infimum over a whole phase, against functions whose infimum is known and against sampling.
#include "numeric/motion/infimum.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/numeric/motion/exact.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using model::Wave;

namespace {

Wave<Ball> wave(const Ball& constant, const Ball& slope = Ball(0)) {
  Wave<Ball> w;
  w.constant = constant;
  w.slope = slope;
  return w;
}

void check_close(const Ball& a, const Ball& b, const char * tolerance) {
  CAPTURE(to_string(a));
  CAPTURE(to_string(b));
  CHECK(a.overlaps(b));
  CHECK((abs(a - b) - exact(tolerance)).is_negative());
}

}  // namespace

TEST_CASE("half the length of an interval does not reach both ends from a rounded middle, reach() does") {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> uniform(0, 20);
  int short_of_an_end = 0;
  for (int k = 0; k < 2000; ++k) {
    const double a = k % 4 == 0 ? 0 : uniform(random);
    const double b = k % 2 == 0 ? a + uniform(random) : a * (1 + (k % 7 + 1) * 0x1p-52);
    const double c = a + (b - a) / 2;
    CAPTURE(a);
    CAPTURE(b);
    const auto reaches_both = [&](double h) {  // 128 bits: exact
      return !(Ball(h) - (Ball(b) - Ball(c))).is_negative() && !(Ball(h) - (Ball(c) - Ball(a))).is_negative();
    };
    CHECK(reaches_both(numeric::scalars::reach(a, c, b)));
    CHECK(numeric::scalars::reach(a, c, b) <= (b - a) / 2 + 2 * (std::nextafter(b, 2 * b) - b));
    short_of_an_end += reaches_both(std::nextafter((b - a) / 2, b)) ? 0 : 1;
  }
  CHECK(short_of_an_end > 100);
}

TEST_CASE("an interior minimum is found to the precision of the balls") {
  Wave<Ball> g = wave(Ball(2));
  g.add(Ball(1), Ball(1), Ball(0));  // 2 + cos t
  const Infimum found = weighted_infimum(g, Ball(5), {});
  check_close(found.value, Ball(1), "1e-28");
  check_close(found.time, Ball::pi(), "1e-14");
}

TEST_CASE("a minimum at an end that is not touched counts") {
  Wave<Ball> g = wave(Ball(0));
  g.add(Ball(1), Ball(1), Ball(0));
  const Infimum at_end = weighted_infimum(g, Ball(2), {});
  check_close(at_end.value, cos(Ball(2)), "1e-30");
  check_close(at_end.time, Ball(2), "1e-15");
  Wave<Ball> rising = wave(exact("0.25"), Ball(1));
  const Infimum at_start = weighted_infimum(rising, Ball(2), {});
  check_close(at_start.value, exact("0.25"), "1e-30");
  check_close(at_start.time, Ball(0), "1e-15");
}

TEST_CASE("touched ends weigh by the distance to them") {
  Wave<Ball> g = wave(Ball(0));
  g.add(Ball(1), Ball(0),
        Ball(1));  // sin t on [0, pi]: least quotient sin(t)/min(1, t) = sin 1, at both t = 1
  const Infimum both = weighted_infimum(g, Ball::pi(), {true, true});
  check_close(both.value, sin(Ball(1)), "1e-28");
  const Infimum none = weighted_infimum(g, Ball::pi(), {});
  CHECK(none.value.contains_zero());
  // On [0, 1/2] the quotient sin(t)/t falls: least at t = 1/2, and 1 - t/6.. is never below.
  const Infimum one = weighted_infimum(g, exact("1/2"), {true, false});
  check_close(one.value, Ball(2) * sin(exact("1/2")), "1e-28");
  check_close(one.time, exact("1/2"), "1e-15");
}

TEST_CASE("a touched end that g leaves with zero speed decides nothing") {
  Wave<Ball> g = wave(Ball(1));
  g.add(Ball(1), Ball(-1), Ball(0));  // 1 - cos t
  const Infimum found = weighted_infimum(g, Ball(2), {true, false});
  CHECK(found.value.contains_zero());
  check_close(found.value, Ball(0), "1e-28");
}

TEST_CASE("grazing: just above, just below, exactly at zero") {
  for (const char * offset : {"1e-20", "-1e-20", "0"}) {
    CAPTURE(offset);
    Wave<Ball> g = wave(Ball(1) + exact(offset));
    g.add(exact("1.7"), exact("0.6"), exact("0.8"));
    const Infimum found = weighted_infimum(g, Ball(7), {});
    check_close(found.value, exact(offset), "1e-27");
    CHECK(found.value.contains_zero() == (offset[0] == '0'));
    const auto proof = violation(WaveCourse(g), Ball(7), found.time);
    CHECK(proof.has_value() == (offset[0] == '-'));
  }
}

TEST_CASE("a violation just inside a touched end is found") {
  Wave<Ball> g = wave(Ball(0), exact("-0.01"));
  g.add(Ball(1), Ball(-1), Ball(0));
  g.constant = Ball(1);  // 1 - cos t - t/100: negative on a short interval after 0
  const Infimum found = weighted_infimum(g, Ball(2), {true, false});
  CHECK(found.value.is_negative());
  const auto proof = violation(WaveCourse(g), Ball(2), found.time);
  REQUIRE(proof.has_value());
  CHECK(proof->value.is_negative());
  CHECK(proof->time.is_positive());
  CHECK(model::value(g, proof->time).is_negative());
}

TEST_CASE("random waves: no sample is below, some sample is near, wide data contain narrow ones") {
  const unsigned seed = 20120;
  INFO("seed ", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> amplitude(-1, 1);
  std::uniform_real_distribution<double> frequency(0.3, 2.5);
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    Wave<Ball> g = wave(Ball(amplitude(random)), Ball(amplitude(random)));
    for (int k = 0; k < 3; ++k) {
      g.add(Ball(frequency(random)), Ball(amplitude(random)), Ball(amplitude(random)));
    }
    const Ball T(1 + 3 * frequency(random));
    const Touches touches{run % 4 == 1 || run % 4 == 3, run % 4 >= 2};
    // Make the touched ends zero: constant and slope are free.
    const Ball g0 = model::value(g, Ball(0));
    const Ball gT = model::value(g, T);
    if (touches.start) {
      g.constant -= g0;
    }
    if (touches.end) {
      const Ball excess = touches.start ? gT - g0 : gT;
      (touches.start ? g.slope : g.constant) -= touches.start ? excess / T : excess;
    }
    const Infimum found = weighted_infimum(g, T, touches);
    REQUIRE(found.value.is_finite());
    CHECK((found.value.radius() - Ball(1e-25)).is_negative());
    bool near = false;
    for (int i = 1; i < 2000; ++i) {
      const Ball t = T * Ball(i) / Ball(2000);
      double w = 1;
      w = touches.start ? std::min(w, t.approximate()) : w;
      w = touches.end ? std::min(w, (T - t).approximate()) : w;
      const double quotient = model::value(g, t).approximate() / w;
      CHECK(quotient > found.value.approximate() - 1e-9);
      near = near || quotient < found.value.approximate() + 5e-2;
    }
    CHECK(near);
    Wave<Ball> wide = g;
    wide.constant += touches.start ? Ball(0) : Ball::hull(Ball(-1e-4), Ball(1e-4));
    wide.harmonics[1].nu += Ball::hull(Ball(-1e-5), Ball(1e-5));
    const Infimum wider = weighted_infimum(wide, T + Ball::hull(Ball(-1e-5), Ball(1e-5)), touches);
    CHECK(wider.value.contains(found.value));
    CHECK((wider.value.radius() - Ball(0.01)).is_negative());
  }
}

TEST_CASE("phases of no, negative or unknown length have no infimum") {
  const Wave<Ball> g = wave(Ball(1));
  CHECK_FALSE(weighted_infimum(g, Ball(0), {}).value.is_finite());
  CHECK_FALSE(weighted_infimum(g, Ball(-1), {}).value.is_finite());
  CHECK_FALSE(weighted_infimum(g, Ball::hull(Ball(-1), Ball(5)), {}).value.is_finite());
  CHECK_FALSE(weighted_infimum(g, Ball(1) / Ball(0), {}).value.is_finite());
}
