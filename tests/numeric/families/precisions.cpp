// The same orbits enclosed at different precisions: the enclosures overlap, and the finer lie in the coarser.
#include <doctest/doctest.h>

#include "tests/numeric/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

using Values = std::vector<Ball>;

// To the accuracy of a double.
Motion in_balls(Motion motion) {
  for (Phase& phase : motion.phases) {
    phase.duration = Ball(phase.duration.approximate());
    phase.load = Ball(phase.load.approximate());
    phase.Z = phase.Z.unaryExpr([](const Ball& x) { return Ball(x.approximate()); });
  }
  return motion;
}

Values values(const Family& family, const Closing& f, const Given<Rational>& given, const Motion& guess,
              int digits) {
  const ClosedMotion closed = prove_closed(f, given, in_balls(guess), digits);
  REQUIRE(closed.existence.truth == Truth::proved);
  const WorkingPrecision scope(bits_for(digits) + 64);
  Values result;
  for (const NamedBall& value : decided_orbit(family, closed, {}).values) {
    result.push_back(value.value);
  }
  return result;
}

// prove: digits -> Values.
template <class Prove>
void check_precisions(const Prove& prove) {
  std::vector<Values> all;
  for (const long bits : {64L, 128L, 256L, 1024L}) {
    CAPTURE(bits);
    all.push_back(prove(static_cast<int>(static_cast<double>(bits) * 0.30103)));
    const WorkingPrecision precision(1200);
    Ball ulps(1);
    arb_mul_2exp_si(ulps.raw(), ulps.raw(), 8 - bits);
    for (const Ball& value : all.back()) {
      CHECK((value.radius() - ulps * (Ball(1) + abs(value))).is_negative());
      for (const Values& other : all) {
        CHECK(value.overlaps(other[static_cast<std::size_t>(&value - all.back().data())]));
      }
    }
  }
}

}  // namespace

TEST_CASE("example S at 64, 128, 256 and 1024 bits") {
  const Motion guess = listed(families::symmetric(), S(), 20).orbits.at(1).motion;
  const Closing f{SymmetricClosing{LoadPhase::first}};
  check_precisions([&](int digits) { return values(families::symmetric(), f, {S()}, guess, digits); });
}

TEST_CASE("example O at 64, 128, 256 and 1024 bits") {
  for (const Orbit& orbit : listed(families::overshooting(), O(), 20, Rational(0)).orbits) {
    const Closing f{OvershootingClosing{true, false}};
    check_precisions([&](int digits) {
      return values(families::overshooting(), f, {O(), Rational(0)}, orbit.motion, digits);
    });
  }
}

TEST_CASE("example P at 64, 128, 256 and 1024 bits") {
  const Motion guess = listed(families::nonsticking(), P(), 20).orbits.at(0).motion;
  const Closing f{NonstickingClosing{}};
  check_precisions([&](int digits) { return values(families::nonsticking(), f, {P()}, guess, digits); });
}

TEST_CASE("a guess beside the orbit is not proved to be one, or a proved one is what its motion says") {
  Motion guess = listed(families::overshooting(), O(), 20, Rational(0)).orbits.at(1).motion;
  guess.phases[0].duration = Ball(4.5);
  guess.phases[1].duration = Ball(2.5);
  const Closing f{OvershootingClosing{true, false}};
  const AtParameters<Closing> system{f, f.parameters({parameters_as<Ball>(O()), Ball(0), {}})};
  const Vector nowhere = box_around<Eigen::Dynamic>(f.unknowns(guess), 1e-3);
  CHECK(krawczyk_test<Eigen::Dynamic>(system, nowhere).verdict.truth != Truth::proved);
  for (const model::Vector4<Ball>& gap : gaps(prove_closed(f, {O(), Rational(0)}, guess, 20).motion)) {
    for (int i = 0; i < 4; ++i) {
      CHECK(gap(i).contains_zero());
    }
  }
}
