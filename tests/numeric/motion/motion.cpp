// Motions as data: the modal waves are the flows, and phases follow each other.
#include "numeric/motion/motion.hpp"

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "tests/numeric/motion/exact.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using model::Vector4;

namespace {

model::Oscillator<Ball> example_O() {
  return model::oscillator<Ball>(
      {exact("0.2"), exact("4"), exact("0.05"), exact("1"), exact("0.6289"), exact("0.05")});
}

Vector4<Ball> start() {
  return {exact("1.2809"), exact("3.3861"), exact("-0.4117"), exact("1")};
}

Motion three_phases() {
  return compose(example_O(), exact("0.3"), start(),
                 {{PhaseKind::slip, exact("4.909")},
                  {PhaseKind::overshoot, exact("2.8275")},
                  {PhaseKind::stick, exact("2.2543")}});
}

// Two enclosures of one number: they overlap, and both are narrow.
void check_same(const Ball& a, const Ball& b) {
  CHECK(a.overlaps(b));
  CHECK((abs(a - b) - Ball(1e-30)).is_negative());
}

}  // namespace

TEST_CASE("waves are the flows of their phase") {
  const Motion motion = three_phases();
  for (std::size_t k = 0; k < 3; ++k) {
    const model::PhaseWaves<Ball> w = waves(motion, k);
    for (const char * text : {"0", "0.7", "-1.3", "9"}) {
      CAPTURE(k);
      CAPTURE(text);
      const Ball t = exact(text);
      const Vector4<Ball> Z = state(motion, k, t);
      check_same(model::value(w.z1, t), Z(0));
      check_same(model::value(w.z2, t), Z(1));
      check_same(model::value(model::derivative(w.z1), t), Z(2));
      check_same(model::value(w.zdot2, t), Z(3));
      check_same(model::value(w.r, t), friction(motion, k, t));
      const Ball T = exact("3.1");
      check_same(model::value(model::reversed(w.r, T), t), model::value(w.r, Ball(T - t)));
      check_same(model::value(model::affine<Ball>(Ball(-3), w.z2, Ball(2)), t), Ball(2) - Ball(3) * Z(1));
    }
  }
}

TEST_CASE("the friction at rest balances the mass during stick, and drives it during slip") {
  const Motion motion = three_phases();
  for (std::size_t k = 0; k < 3; ++k) {
    const model::PhaseWaves<Ball> w = waves(motion, k);
    const Ball t = exact("0.4");
    const Ball eta = motion.oscillator.data.eta;
    const Ball us = motion.oscillator.data.us;
    const Ball r = friction(motion, k, t);
    const Ball u = k == 0 ? us : (k == 1 ? -us : r);  // (4)
    check_same(model::value(model::derivative(w.zdot2), t), eta * (u - r));
  }
}

TEST_CASE("phases follow each other, and the gaps tell where they do not") {
  Motion motion = three_phases();
  check_same(period(motion), exact("9.9908"));
  check_same(motion.phases[1].load, exact("4.909") * exact("0.6289") + exact("0.3"));
  const std::vector<Vector4<Ball>> closed = gaps(motion);
  REQUIRE(closed.size() == 3);
  for (int i = 0; i < 4; ++i) {
    CHECK(closed[0](i).contains_zero());
    CHECK(closed[1](i).contains_zero());
  }
  CHECK(closed[2](0).is_nonzero());  // phi = 0.3 is not that of the orbit
  std::swap(motion.phases[0].Z, motion.phases[1].Z);
  CHECK(gaps(motion)[0](0).is_nonzero());
}

TEST_CASE("there is no state in a phase that the motion has not") {
  CHECK_THROWS_AS((void)state(three_phases(), 3, exact("0")), InternalError);
}
